//! The library names no argument of the command line: what it says is read by callers that have none.

use std::fs;

use proc_macro2::{TokenStream, TokenTree};

use crate::sources::{files, root};

#[test]
fn messages_outside_of_the_command_line_name_no_flag() {
    let source = root();
    let mut read = 0;
    let mut found = Vec::new();
    for file in files(&source) {
        if file.starts_with(source.join("cli")) {
            continue;
        }
        let text = fs::read_to_string(&file).unwrap();
        let tokens: TokenStream = text.parse().unwrap();
        let with_flags = literals(tokens).into_iter().filter(|text| names_flag(text));
        found.extend(with_flags.map(|text| format!("{}: {text}", file.display())));
        read += 1;
    }
    assert!(read > 200, "only {read} files were read");
    assert_eq!(found, Vec::<String>::new());
}

#[test]
fn a_flag_is_noticed_and_a_comment_or_an_arrow_is_not() {
    let flags = |text: &str| {
        let all = literals(text.parse().unwrap());
        all.iter().filter(|text| names_flag(text)).count()
    };
    assert_eq!(flags(r#"fn f() { format!("say --peels 4"); }"#), 1);
    assert_eq!(flags(r#"const A: &str = "render with -m exact";"#), 1);
    assert_eq!(flags(r#"/// As --peels has it."#), 0);
    assert_eq!(flags(r#"const A: &str = "a -> b -- c -";"#), 0);
}

/// Every literal, those within macros too, but for attributes, as which comments of documentation are read.
fn literals(tokens: TokenStream) -> Vec<String> {
    let mut found = Vec::new();
    let mut in_attribute = false;
    for token in tokens {
        match token {
            TokenTree::Punct(punct) if matches!(punct.as_char(), '#' | '!') => {
                in_attribute = in_attribute || punct.as_char() == '#';
                continue;
            }
            TokenTree::Group(group) if !in_attribute => found.extend(literals(group.stream())),
            TokenTree::Literal(literal) => found.push(literal.to_string()),
            _ => {}
        }
        in_attribute = false;
    }
    found
}

fn names_flag(literal: &str) -> bool {
    let long = literal.match_indices("--").any(|(at, _)| {
        let next = literal[at + 2..].chars().next();
        next.is_some_and(|c| c.is_ascii_lowercase())
    });
    long || literal.contains(" -m ") || literal.contains("(-m ")
}
