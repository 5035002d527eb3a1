//! `onionskin listing`: the papers' listings, printed from the data that runs.

use std::process::ExitCode;

use clap::Args;
use clap::builder::styling::{AnsiColor, Style};
use onionskin::low_level::edition::listing_json;
use onionskin::low_level::error::did_you_mean;
use onionskin::low_level::steps::{
    self, Amendment, Origin, Reading, Recorder, TextLine, Variables, free_variables, run,
};
use onionskin::{Error, Result, Text, papers, texts};

use super::output::{print_json, say, say_styled};

/// Print the papers' listings
///
/// The listings are printed from the data that runs. A letter in the margin says where each line comes from: p if the
/// paper prints it, s if the paper says it in a sentence, f if it fills what the paper leaves open, a if it amends what
/// is wrong in the paper, e if it is this edition's own. By default listings are printed as amended, with --as-printed
/// without amendments, and with --literal without fillings, too: there ? says where the paper is silent. Without an
/// argument, the names of all listings are printed. Needs no OpenGL.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Listing {
    /// A paper, for all of its listings, or one listing, such as everitt/listing-1
    #[arg(value_name = "PAPER[/LISTING]")]
    name: Option<String>,
    /// Leave out what amends the paper; what fills its silence stays
    #[arg(long)]
    as_printed: bool,
    /// Leave out what fills the paper's silence, too
    #[arg(long, conflicts_with = "as_printed")]
    literal: bool,
    /// Print one JSON object for each listing: its lines with their origins, and its steps
    #[arg(long, conflicts_with = "unroll")]
    json: bool,
    /// Print the calls of N rounds of the listing's loop instead, 1 to 1000: one call per line, every argument named
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    unroll: Option<u32>,
    /// The value of a variable that the listing reads and does not set, for --unroll; give it once per variable
    #[arg(long, value_name = "NAME=VALUE", value_parser = variable, requires = "unroll")]
    set: Vec<(String, f64)>,
}

const EXAMPLES: &str = "\
Examples:
  onionskin listing                                     the names of all listings
  onionskin listing everitt/listing-1 --as-printed
  onionskin listing carr/pass-1 --as-printed | sed -n 's/^p //p'   nothing but what the paper prints
  onionskin listing everitt/listing-1 --unroll 2        two peels, call by call
  onionskin listing everitt/listing-1 --unroll 2 --set num_passes=3";

impl Listing {
    pub(super) fn run(self) -> Result<ExitCode> {
        let Some(name) = &self.name else {
            return index();
        };
        for (at, (name, text)) in texts(name)?.into_iter().enumerate() {
            if self.json {
                print_json(&listing_json::object(&name, text, self.reading()))?;
                continue;
            }
            if at > 0 {
                say("")?;
            }
            say_styled(&self.styled(&name, text)?)?;
        }
        Ok(ExitCode::SUCCESS)
    }

    fn reading(&self) -> Reading {
        match (self.literal, self.as_printed) {
            (true, _) => Reading::Literal,
            (_, true) => Reading::AsPrinted,
            _ => Reading::Amended,
        }
    }

    fn styled(&self, name: &str, text: &Text) -> Result<Vec<(Style, String)>> {
        let plain = |line: &str| (Style::new(), line.to_owned());
        let mut all = vec![plain(&format!("// {}: {}", text.source(), text.title()))];
        match (self.unroll, text) {
            (Some(rounds), Text::Listing(listing, amendments)) => {
                let amendments = self.reading().of(amendments);
                let calls = unroll(listing, &amendments, rounds, &self.set)?;
                all.extend(calls.lines().map(plain));
            }
            // A paper as a whole unrolls what it can.
            (Some(_), _) if self.name.as_deref() == Some(name) => {
                return Err(Error::usage(
                    format!("{name} is pseudocode, which makes no calls"),
                    "--unroll is for listings; what OpenGL runs for it is carr/hybrid, carr/ideal or lindholm/pp-ao",
                ));
            }
            _ => all.extend(margins(&text.lines(self.reading()))),
        }
        Ok(all)
    }
}

/// The lines with their letters, and what the letters mean.
fn margins(lines: &[TextLine]) -> Vec<(Style, String)> {
    let letter = |line: &TextLine| line.origin.map_or(' ', Origin::letter);
    let with_margin = |line: &TextLine| {
        let margin = format!("{} {}", letter(line), line.text);
        (style(letter(line)), margin.trim_end().to_owned())
    };
    let mut all: Vec<_> = lines.iter().map(with_margin).collect();
    all.push((Style::new(), String::new()));
    let used = |(letter, _): &(char, &str)| all.iter().any(|(_, line)| line.starts_with(*letter));
    let legend: Vec<_> = Origin::LEGEND
        .into_iter()
        .filter(used)
        .map(|(letter, meaning)| (style(letter), format!("  {letter} {meaning}")))
        .collect();
    all.extend(legend);
    all
}

/// The colour of an origin. What is printed has the terminal's own.
fn style(letter: char) -> Style {
    match letter {
        's' => AnsiColor::Cyan.on_default(),
        '?' => AnsiColor::Red.on_default(),
        'f' => AnsiColor::Green.on_default(),
        'a' => AnsiColor::Yellow.on_default(),
        'e' => AnsiColor::Magenta.on_default(),
        _ => Style::new(),
    }
}

/// Every name with its title.
fn index() -> Result<ExitCode> {
    for paper in papers() {
        say(paper.citation)?;
        for (key, text) in paper.texts {
            let name = format!("{}/{key}", paper.key);
            say(format_args!("  {name:<28} {}", text.title()))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// The values of a listing's free variables: those that --set gives, and those that a loop of so many rounds needs.
/// Every query is answered as if each peel had found one fragment.
fn unroll(
    listing: &steps::Listing,
    amendments: &[Amendment],
    rounds: u32,
    set: &[(String, f64)],
) -> Result<String> {
    let free = free_variables(listing, amendments);
    let mut variables = ROUNDS
        .into_iter()
        .fold(Variables::new(), |variables, name| {
            variables.with(name, f64::from(rounds))
        })
        .with("occlusion_ratio", 0.0)
        .with("window_area", 1.0)
        .with("composited", 0.0);
    for (name, value) in set {
        let known = free.iter().find(|other| *other == name);
        variables.set(known.ok_or_else(|| not_free(name, &free))?, *value);
    }
    let missing = |name: &&&str| variables.get(name).is_none();
    let missing: Vec<&str> = free.iter().filter(missing).copied().collect();
    let mut recorder = Recorder::new().answering_every_query(1);
    let done = run(listing, amendments, variables, &mut recorder);
    // A variable need not have a value if it is read only in steps that an amendment replaces.
    done.map_err(|error| match missing[..] {
        [] => error,
        [first, ..] => Error::usage(
            format!(
                "'{}' reads variables that nothing sets: {}",
                listing.title,
                missing.join(", ")
            ),
            format!("Give each a value, as in --set {first}=4."),
        ),
    })?;
    Ok(recorder.trace())
}

/// Variables that give the number of rounds.
const ROUNDS: [&str; 3] = ["num_passes", "num_layers", "iteration_limit"];

fn not_free(name: &str, free: &[&str]) -> Error {
    let remedy = if free.is_empty() {
        "It has none: leave out --set.".to_owned()
    } else {
        did_you_mean(name, free)
    };
    Error::usage(format!("the listing has no free variable '{name}'"), remedy)
}

fn variable(text: &str) -> Result<(String, f64)> {
    let wrong = || {
        Error::usage(
            format!("'{text}' sets no variable"),
            "write NAME=VALUE, such as num_passes=4, with a value from -1000000 to 1000000",
        )
    };
    let (name, value) = text.split_once('=').ok_or_else(wrong)?;
    let value: f64 = value.trim().parse().map_err(|_| wrong())?;
    // The range makes loops end, and excludes NaN.
    if name.trim().is_empty() || !(-1e6..=1e6).contains(&value) {
        return Err(wrong());
    }
    Ok((name.trim().to_owned(), value))
}
