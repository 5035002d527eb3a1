//! The macros in which listings are written.

/// Steps, written as the papers write them, as a `&'static [Step]`.
///
/// - OpenGL calls: `glDepthFunc(LESS);`, with [`steps::gl`](crate::steps::gl) in scope.
/// - Everitt's phrases: `clear color buffer;`, `set depth func to GREATER;`, `depth unit 0: { ... }`.
/// - Variables: `A = i % 2;`, `B = (i+1) % 2;`, `count = samples(PEEL);` with a [`Query`](crate::steps::Query).
/// - Branches: `if (i == 0) { ... } else { ... }`, `for (i in 0..num_passes) { ... }`,
///   `for (i in num_layers..0) { ... }` (downwards, from num_layers - 1 to 0),
///   `stop if (count == 0) because EmptyLayer;`, `run LISTING amended by AMENDMENTS;`.
/// - [`Margin`](crate::steps::Margin)s: `printed;`, `prose "...";` and `edition "...";` say where the steps that follow come
///   from; `spelt "...";` says how the paper spells the next one, and `line "...";` is a line of the paper that does nothing.
///
/// ```
/// use onionskin::low_level::steps::{*, gl::*};
/// let pass = onionskin::steps! {
///     glClearDepth(1.0);
///     glClear(DEPTH_BUFFER_BIT);
///     for (i in 0..3) {
///         drawTransparentObjects();
///     }
/// };
/// assert_eq!(pass.len(), 3);
/// ```
#[macro_export]
macro_rules! steps {
    ($($step:tt)*) => {
        {
            const STEPS: &[$crate::low_level::steps::Step] = $crate::steps_of!([] $($step)*);
            STEPS
        }
    };
}

/// There is one rule per kind of step. It takes the first step, puts it behind those that are done, and goes on with
/// the rest.
#[doc(hidden)]
#[macro_export]
macro_rules! steps_of {
    ([$($done:expr,)*]) => { &[$($done,)*] };

    // Marks.
    ([$($done:expr,)*] printed; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Margin($crate::margin_of!(printed)),] $($rest)*)
    };
    ([$($done:expr,)*] prose $quote:literal; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Margin($crate::margin_of!(prose $quote)),] $($rest)*)
    };
    ([$($done:expr,)*] edition $why:literal; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Margin($crate::margin_of!(edition $why)),] $($rest)*)
    };
    ([$($done:expr,)*] spelt $text:literal $(meaning $meaning:literal)?; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Margin($crate::margin_of!(spelt $text $(meaning $meaning)?)),] $($rest)*)
    };
    ([$($done:expr,)*] line $text:literal; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Margin($crate::margin_of!(line $text)),] $($rest)*)
    };

    // Everitt's phrases.
    ([$($done:expr,)*] clear color buffer; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Call($crate::low_level::steps::gl::glClear($crate::low_level::steps::gl::COLOR_BUFFER_BIT)),] $($rest)*)
    };
    ([$($done:expr,)*] clear depth buffer; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Call($crate::low_level::steps::gl::glClear($crate::low_level::steps::gl::DEPTH_BUFFER_BIT)),] $($rest)*)
    };
    ([$($done:expr,)*] enable depth test; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Call($crate::low_level::steps::gl::glEnable($crate::low_level::steps::gl::DEPTH_TEST)),] $($rest)*)
    };
    ([$($done:expr,)*] disable depth test; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Call($crate::low_level::steps::gl::glDisable($crate::low_level::steps::gl::DEPTH_TEST)),] $($rest)*)
    };
    ([$($done:expr,)*] enable depth writes; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Call($crate::low_level::steps::gl::glDepthMask(true)),] $($rest)*)
    };
    ([$($done:expr,)*] disable depth writes; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Call($crate::low_level::steps::gl::glDepthMask(false)),] $($rest)*)
    };
    ([$($done:expr,)*] set depth func to $func:ident; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Call($crate::low_level::steps::gl::glDepthFunc($crate::low_level::steps::gl::$func)),] $($rest)*)
    };
    ([$($done:expr,)*] bind buffer $buffer:ident; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Call($crate::low_level::steps::gl::bindDepthBuffer(
            $crate::low_level::steps::Map::at("depth buffer", stringify!($buffer)),
        )),] $($rest)*)
    };
    ([$($done:expr,)*] render scene; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Call($crate::low_level::steps::gl::draw($crate::low_level::steps::Objects::Scene)),] $($rest)*)
    };
    ([$($done:expr,)*] save color buffer RGBA as layer $layer:ident; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Call($crate::low_level::steps::gl::glCopyImageSubData(
            $crate::low_level::steps::Map::named("color buffer"),
            $crate::low_level::steps::Map::at("layer", stringify!($layer)),
        )),] $($rest)*)
    };
    ([$($done:expr,)*] depth unit $unit:literal: { $($body:tt)* } $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::DepthUnit {
            unit: $unit,
            body: $crate::steps!($($body)*),
        },] $($rest)*)
    };

    // Branches.
    ([$($done:expr,)*] if ($($condition:tt)*) { $($then:tt)* } else { $($otherwise:tt)* } $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::If {
            condition: $crate::condition_of!($($condition)*),
            then: $crate::steps!($($then)*),
            otherwise: $crate::steps!($($otherwise)*),
        },] $($rest)*)
    };
    ([$($done:expr,)*] if ($($condition:tt)*) { $($then:tt)* } $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::If {
            condition: $crate::condition_of!($($condition)*),
            then: $crate::steps!($($then)*),
            otherwise: &[],
        },] $($rest)*)
    };
    ([$($done:expr,)*] for ($i:ident in 0..$to:ident) { $($body:tt)* } $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::For {
            variable: stringify!($i),
            from: $crate::low_level::steps::Expr::Number(0.0),
            to: $crate::low_level::steps::Expr::Variable(stringify!($to)),
            body: $crate::steps!($($body)*),
        },] $($rest)*)
    };
    ([$($done:expr,)*] for ($i:ident in 0..$to:literal) { $($body:tt)* } $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::For {
            variable: stringify!($i),
            from: $crate::low_level::steps::Expr::Number(0.0),
            to: $crate::low_level::steps::Expr::Number($to as f64),
            body: $crate::steps!($($body)*),
        },] $($rest)*)
    };
    ([$($done:expr,)*] for ($i:ident in $from:ident..0) { $($body:tt)* } $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::ForDown {
            variable: stringify!($i),
            from: $crate::low_level::steps::Expr::Variable(stringify!($from)),
            body: $crate::steps!($($body)*),
        },] $($rest)*)
    };
    ([$($done:expr,)*] stop if ($($condition:tt)*) because $why:ident; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Stop {
            when: $crate::condition_of!($($condition)*),
            why: $crate::low_level::steps::Reason::$why,
        },] $($rest)*)
    };
    ([$($done:expr,)*] run $listing:path; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Run { listing: &$listing, amendments: &[] },] $($rest)*)
    };
    ([$($done:expr,)*] run $listing:ident amended by $amendments:expr; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Run {
            listing: &$listing,
            amendments: $amendments,
        },] $($rest)*)
    };

    // Variables: everything up to the semicolon is the expression.
    ([$($done:expr,)*] $variable:ident = $($rest:tt)*) => {
        $crate::steps_of!(@let $variable [] [$($done,)*] $($rest)*)
    };
    (@let $variable:ident [$($value:tt)*] [$($done:expr,)*] ; $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Let {
            variable: stringify!($variable),
            value: $crate::expr_of!($($value)*),
        },] $($rest)*)
    };
    (@let $variable:ident [$($value:tt)*] [$($done:expr,)*] $next:tt $($rest:tt)*) => {
        $crate::steps_of!(@let $variable [$($value)* $next] [$($done,)*] $($rest)*)
    };

    // OpenGL's calls.
    ([$($done:expr,)*] $call:ident($($argument:expr),*); $($rest:tt)*) => {
        $crate::steps_of!([$($done,)* $crate::low_level::steps::Step::Call($crate::low_level::steps::gl::$call($($argument),*)),] $($rest)*)
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! margin_of {
    (printed) => {
        $crate::low_level::steps::Margin::From($crate::low_level::steps::Origin::Printed)
    };
    (prose $quote:literal) => {
        $crate::low_level::steps::Margin::From($crate::low_level::steps::Origin::Prose {
            quote: $quote,
        })
    };
    (edition $why:literal) => {
        $crate::low_level::steps::Margin::From($crate::low_level::steps::Origin::Edition {
            why: $why,
        })
    };
    (spelt $text:literal) => {
        $crate::low_level::steps::Margin::Spelt {
            text: $text,
            meaning: ::core::option::Option::None,
        }
    };
    (spelt $text:literal meaning $meaning:literal) => {
        $crate::low_level::steps::Margin::Spelt {
            text: $text,
            meaning: ::core::option::Option::Some($meaning),
        }
    };
    (line $text:literal) => {
        $crate::low_level::steps::Margin::Line($text)
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! expr_of {
    ($number:literal) => { $crate::low_level::steps::Expr::Number($number as f64) };
    ($variable:ident) => { $crate::low_level::steps::Expr::Variable(stringify!($variable)) };
    (($($inner:tt)+)) => { $crate::expr_of!($($inner)+) };
    (samples($query:ident)) => { $crate::low_level::steps::Expr::Samples($query) };
    ($a:tt + samples($query:ident)) => {
        $crate::low_level::steps::Expr::Sum(&$crate::expr_of!($a), &$crate::low_level::steps::Expr::Samples($query))
    };
    ($a:tt + $b:tt) => { $crate::low_level::steps::Expr::Sum(&$crate::expr_of!($a), &$crate::expr_of!($b)) };
    ($a:tt - $b:tt) => { $crate::low_level::steps::Expr::Difference(&$crate::expr_of!($a), &$crate::expr_of!($b)) };
    ($a:tt * $b:tt) => { $crate::low_level::steps::Expr::Product(&$crate::expr_of!($a), &$crate::expr_of!($b)) };
    ($a:tt % $b:tt) => { $crate::low_level::steps::Expr::Remainder(&$crate::expr_of!($a), &$crate::expr_of!($b)) };
}

#[doc(hidden)]
#[macro_export]
macro_rules! condition_of {
    ($a:tt == $b:tt) => { $crate::condition_of!($a Equal $b) };
    ($a:tt < $b:tt) => { $crate::condition_of!($a Less $b) };
    ($a:tt > $b:tt) => { $crate::condition_of!($a Greater $b) };
    ($a:tt $compare:ident $b:tt) => {
        $crate::low_level::steps::Condition {
            left: $crate::expr_of!($a),
            compare: $crate::low_level::steps::Compare::$compare,
            right: $crate::expr_of!($b),
        }
    };
}
