//! The macros in which pseudocode is written.

/// The lines of a [`Pseudocode`](crate::steps::pseudo::Pseudocode), written as the paper writes them, as a
/// `&'static [Line]`.
///
/// ```
/// use onionskin::low_level::steps::pseudo::*;
/// const LINES: &[Line] = onionskin::pseudo! {
///     gChanged <- true;
///     while gChanged = true do {
///         for all Transparent "geometry sample locations" do {
///             if (zPeel < zFragment < z2) then { composite; } else if (zFragment = zPeel) then { z1 <- z2; }
///         }
///     }
/// };
/// assert_eq!(LINES.len(), 2);
/// ```
#[macro_export]
macro_rules! pseudo {
    ($($line:tt)*) => {
        {
            const LINES: &[$crate::low_level::steps::pseudo::Line] = $crate::pseudo_lines!([] $($line)*);
            LINES
        }
    };
}

/// One rule a kind of line: takes the first off, puts it behind those that are done, and goes on with the rest.
#[doc(hidden)]
#[macro_export]
macro_rules! pseudo_lines {
    ([$($done:expr,)*]) => { &[$($done,)*] };

    // Marks.
    ([$($done:expr,)*] printed; $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Margin($crate::margin_of!(printed)),] $($rest)*)
    };
    ([$($done:expr,)*] prose $quote:literal; $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Margin($crate::margin_of!(prose $quote)),] $($rest)*)
    };
    ([$($done:expr,)*] edition $why:literal; $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Margin($crate::margin_of!(edition $why)),] $($rest)*)
    };
    ([$($done:expr,)*] spelt $text:literal; $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Margin($crate::margin_of!(spelt $text)),] $($rest)*)
    };
    ([$($done:expr,)*] line $text:literal; $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Margin($crate::margin_of!(line $text)),] $($rest)*)
    };

    ([$($done:expr,)*] for all pixel sample locations do { $($body:tt)* } $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Pixels($crate::pseudo!($($body)*)),] $($rest)*)
    };
    ([$($done:expr,)*] for all $of:ident $phrase:literal do { $($body:tt)* } $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Fragments {
            of: $crate::low_level::steps::Objects::$of,
            phrase: $phrase,
            body: $crate::pseudo!($($body)*),
        },] $($rest)*)
    };
    ([$($done:expr,)*] while $flag:ident = true do { $($body:tt)* } $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::While {
            flag: stringify!($flag),
            body: $crate::pseudo!($($body)*),
        },] $($rest)*)
    };
    // if ... else if ...: the rest of the chain is collected into the 'else'.
    ([$($done:expr,)*] if ($($test:tt)*) then { $($then:tt)* } else if $($rest:tt)*) => {
        $crate::pseudo_lines!(@chain [$($done,)*] [$($test)*] [$($then)*] if $($rest)*)
    };
    ([$($done:expr,)*] if ($($test:tt)*) then { $($then:tt)* } else { $($otherwise:tt)* } $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::If {
            test: $crate::pseudo_test!($($test)*),
            then: $crate::pseudo!($($then)*),
            otherwise: $crate::pseudo!($($otherwise)*),
        },] $($rest)*)
    };
    ([$($done:expr,)*] if ($($test:tt)*) then { $($then:tt)* } $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::If {
            test: $crate::pseudo_test!($($test)*),
            then: $crate::pseudo!($($then)*),
            otherwise: &[],
        },] $($rest)*)
    };
    (@chain [$($done:expr,)*] [$($test:tt)*] [$($then:tt)*]
        if ($($test_2:tt)*) then { $($then_2:tt)* } else if ($($test_3:tt)*) then { $($then_3:tt)* } else { $($otherwise:tt)* }
        $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::If {
            test: $crate::pseudo_test!($($test)*),
            then: $crate::pseudo!($($then)*),
            otherwise: $crate::pseudo!(
                if ($($test_2)*) then { $($then_2)* } else if ($($test_3)*) then { $($then_3)* } else { $($otherwise)* }
            ),
        },] $($rest)*)
    };
    (@chain [$($done:expr,)*] [$($test:tt)*] [$($then:tt)*]
        if ($($test_2:tt)*) then { $($then_2:tt)* } else { $($otherwise:tt)* } $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::If {
            test: $crate::pseudo_test!($($test)*),
            then: $crate::pseudo!($($then)*),
            otherwise: $crate::pseudo!(if ($($test_2)*) then { $($then_2)* } else { $($otherwise)* }),
        },] $($rest)*)
    };
    (@chain [$($done:expr,)*] [$($test:tt)*] [$($then:tt)*]
        if ($($test_2:tt)*) then { $($then_2:tt)* } $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::If {
            test: $crate::pseudo_test!($($test)*),
            then: $crate::pseudo!($($then)*),
            otherwise: $crate::pseudo!(if ($($test_2)*) then { $($then_2)* }),
        },] $($rest)*)
    };
    ([$($done:expr,)*] composite; $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Composite,] $($rest)*)
    };
    ([$($done:expr,)*] swap($a:ident, $b:ident); $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Swap(stringify!($a), stringify!($b)),] $($rest)*)
    };
    ([$($done:expr,)*] $variable:ident <- $flag:literal; $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Set {
            variable: stringify!($variable),
            value: $crate::low_level::steps::pseudo::Value::Flag($flag),
        },] $($rest)*)
    };
    ([$($done:expr,)*] $variable:ident <- before zNear; $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Set {
            variable: stringify!($variable),
            value: $crate::low_level::steps::pseudo::Value::BeforeEverything,
        },] $($rest)*)
    };
    ([$($done:expr,)*] $variable:ident <- $a:ident if $flag:ident else $b:ident; $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Set {
            variable: stringify!($variable),
            value: $crate::low_level::steps::pseudo::Value::Either(stringify!($flag), stringify!($a), stringify!($b)),
        },] $($rest)*)
    };
    ([$($done:expr,)*] $variable:ident <- $value:ident; $($rest:tt)*) => {
        $crate::pseudo_lines!([$($done,)* $crate::low_level::steps::pseudo::Line::Set {
            variable: stringify!($variable),
            value: $crate::low_level::steps::pseudo::Value::Of(stringify!($value)),
        },] $($rest)*)
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! pseudo_test {
    ($flag:ident = true) => {
        $crate::low_level::steps::pseudo::Test::Set(stringify!($flag))
    };
    ($a:ident = $b:ident and $c:ident < $d:ident) => {
        $crate::low_level::steps::pseudo::Test::Both(
            (
                stringify!($a),
                $crate::low_level::steps::Compare::Equal,
                stringify!($b),
            ),
            (
                stringify!($c),
                $crate::low_level::steps::Compare::Less,
                stringify!($d),
            ),
        )
    };
    ($a:ident = $b:ident) => {
        $crate::low_level::steps::pseudo::Test::One(
            stringify!($a),
            $crate::low_level::steps::Compare::Equal,
            stringify!($b),
        )
    };
    ($a:ident < $b:ident < $c:ident) => {
        $crate::low_level::steps::pseudo::Test::Two(
            stringify!($a),
            $crate::low_level::steps::Compare::Less,
            stringify!($b),
            $crate::low_level::steps::Compare::Less,
            stringify!($c),
        )
    };
    ($a:ident <= $b:ident < $c:ident) => {
        $crate::low_level::steps::pseudo::Test::Two(
            stringify!($a),
            $crate::low_level::steps::Compare::Lequal,
            stringify!($b),
            $crate::low_level::steps::Compare::Less,
            stringify!($c),
        )
    };
    ($a:ident < $b:ident) => {
        $crate::low_level::steps::pseudo::Test::One(
            stringify!($a),
            $crate::low_level::steps::Compare::Less,
            stringify!($b),
        )
    };
}

/// The lines of an algorithm on lists of fragments, written as the paper writes them, as a
/// `&'static [list::ListLine]`.
///
/// ```
/// use onionskin::low_level::steps::pseudo::list::{Key, ListLine, ListTest};
/// use onionskin::low_level::steps::pseudo::list::ListLine::*;
/// const LINES: &[ListLine] = onionskin::lists! {
///     foreach fragment f do {
///         if (depth <= min depth) then { skip f; } else { insert f by depth; }
///     }
/// };
/// const SKIP_OR_INSERT: ListLine = If(ListTest::NotBehindMin(Key::Depth), &[Skip], &[Insert(Key::Depth)]);
/// assert_eq!(LINES, [Fragments(&[SKIP_OR_INSERT])]);
/// ```
#[macro_export]
macro_rules! lists {
    ($($line:tt)*) => {
        {
            #[allow(unused_imports)]
            use $crate::low_level::steps::pseudo::list::{
                Beginning, Counter, Element, End, Key, ListLine, Mark, SegmentEnd, Start, Taken, ListTest,
            };
            const LINES: &[ListLine] = $crate::list_lines!([] $($line)*);
            LINES
        }
    };
}

/// One rule a kind of line: takes the first off, puts it behind those that are done, and goes on with the rest.
#[doc(hidden)]
#[macro_export]
macro_rules! list_lines {
    ([$($done:expr,)*]) => { &[$($done,)*] };

    // Marks.
    ([$($done:expr,)*] printed; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Margin($crate::margin_of!(printed)),] $($rest)*)
    };
    ([$($done:expr,)*] prose $quote:literal; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Margin($crate::margin_of!(prose $quote)),] $($rest)*)
    };
    ([$($done:expr,)*] edition $why:literal; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Margin($crate::margin_of!(edition $why)),] $($rest)*)
    };
    ([$($done:expr,)*] spelt $text:literal; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Margin($crate::margin_of!(spelt $text)),] $($rest)*)
    };
    ([$($done:expr,)*] line $text:literal; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Margin($crate::margin_of!(line $text)),] $($rest)*)
    };

    // Loops and branches.
    ([$($done:expr,)*] forall pixels do { $($body:tt)* } $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Pixels($crate::list_lines!([] $($body)*)),] $($rest)*)
    };
    ([$($done:expr,)*] forall unresolved pixels do { $($body:tt)* } $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::UnresolvedPixels($crate::list_lines!([] $($body)*)),] $($rest)*)
    };
    ([$($done:expr,)*] foreach segment i do { $($body:tt)* } $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Segments($crate::list_lines!([] $($body)*)),] $($rest)*)
    };
    ([$($done:expr,)*] foreach fragment f do { $($body:tt)* } $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Fragments($crate::list_lines!([] $($body)*)),] $($rest)*)
    };
    ([$($done:expr,)*] foreach sorted fragment f do { $($body:tt)* } $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Sorted($crate::list_lines!([] $($body)*)),] $($rest)*)
    };
    ([$($done:expr,)*] foreach element f of buffer do { $($body:tt)* } $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Elements($crate::list_lines!([] $($body)*)),] $($rest)*)
    };
    ([$($done:expr,)*] repeat { $($body:tt)* } until $($rest:tt)*) => {
        $crate::list_lines!(@until [$($done,)*] [$($body)*] [] $($rest)*)
    };
    (@until [$($done:expr,)*] [$($body:tt)*] [$($end:tt)*] ; $($rest:tt)*) => {
        $crate::list_lines!(
            [$($done,)* ListLine::Repeat($crate::list_lines!([] $($body)* until $($end)*;)),]
            $($rest)*
        )
    };
    (@until [$($done:expr,)*] [$($body:tt)*] [$($end:tt)*] $next:tt $($rest:tt)*) => {
        $crate::list_lines!(@until [$($done,)*] [$($body)*] [$($end)* $next] $($rest)*)
    };
    ([$($done:expr,)*] until all fragments are resolved; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Until(End::AllResolved),] $($rest)*)
    };
    ([$($done:expr,)*] until no element was dropped; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Until(End::NothingDropped),] $($rest)*)
    };
    ([$($done:expr,)*] if ($($test:tt)*) then { $($then:tt)* } else { $($otherwise:tt)* } $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::If(
            $crate::list_test!($($test)*),
            $crate::list_lines!([] $($then)*),
            $crate::list_lines!([] $($otherwise)*),
        ),] $($rest)*)
    };
    ([$($done:expr,)*] if ($($test:tt)*) then { $($then:tt)* } $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::If(
            $crate::list_test!($($test)*),
            $crate::list_lines!([] $($then)*),
            &[],
        ),] $($rest)*)
    };

    // The Fill Step, and ppAO.
    ([$($done:expr,)*] note $note:literal; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Note($note),] $($rest)*)
    };
    ([$($done:expr,)*] count depth complexity; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Count(Counter::Integer),] $($rest)*)
    };
    ([$($done:expr,)*] activate shader program; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::ActivateProgram,] $($rest)*)
    };
    ([$($done:expr,)*] resolve segment with Local Array; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::ResolveSegment,] $($rest)*)
    };
    ([$($done:expr,)*] resolve segment by $algorithm:ident; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Run(&$algorithm, &[]),] $($rest)*)
    };
    ([$($done:expr,)*] resolve segment by $algorithm:ident amended by $amendments:expr; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Run(&$algorithm, $amendments),] $($rest)*)
    };
    ([$($done:expr,)*] mark pixel as resolved; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Mark(Mark::Resolved),] $($rest)*)
    };

    // ppDP.
    ([$($done:expr,)*] input list of fragments; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Input,] $($rest)*)
    };
    ([$($done:expr,)*] n <- sizeof Local Array; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::SizeOfLocalArray,] $($rest)*)
    };
    ([$($done:expr,)*] create buffer with n elements; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::CreateBuffer,] $($rest)*)
    };
    ([$($done:expr,)*] set min depth to 0; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::SetMin(Start::Zero),] $($rest)*)
    };
    ([$($done:expr,)*] set min depth before all; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::SetMin(Start::BeforeAll),] $($rest)*)
    };
    ([$($done:expr,)*] initialize current state; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::InitializeState,] $($rest)*)
    };
    ([$($done:expr,)*] skip f; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Skip,] $($rest)*)
    };
    ([$($done:expr,)*] insert f by depth; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Insert(Key::Depth),] $($rest)*)
    };
    ([$($done:expr,)*] insert f by depth, then id; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Insert(Key::DepthAndId),] $($rest)*)
    };
    ([$($done:expr,)*] resolve buffer; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::ResolveBuffer(Taken::All),] $($rest)*)
    };
    ([$($done:expr,)*] resolve buffer, on overflow its first n - 1 elements; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::ResolveBuffer(Taken::AllButLastOnOverflow),] $($rest)*)
    };
    ([$($done:expr,)*] store min depth of last buffer element; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Store(Key::Depth, Element::Last),] $($rest)*)
    };
    ([$($done:expr,)*] store min depth and id of last buffer element; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Store(Key::DepthAndId, Element::Last),] $($rest)*)
    };
    ([$($done:expr,)*] store min depth and id of last resolved element; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Store(Key::DepthAndId, Element::LastResolved),] $($rest)*)
    };
    ([$($done:expr,)*] clear buffer; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::ClearBuffer,] $($rest)*)
    };

    // Rays.
    ([$($done:expr,)*] begin ray outside; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::BeginRay(Beginning::Outside),] $($rest)*)
    };
    ([$($done:expr,)*] begin ray inside what is only left; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::BeginRay(Beginning::WhatIsOnlyLeft),] $($rest)*)
    };
    ([$($done:expr,)*] cast ray up to f; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Cast(SegmentEnd::Fragment),] $($rest)*)
    };
    ([$($done:expr,)*] cast ray up to f or opaque depth; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Cast(SegmentEnd::FragmentOrOpaque),] $($rest)*)
    };
    ([$($done:expr,)*] toggle the volume of f; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Toggle,] $($rest)*)
    };
    ([$($done:expr,)*] blend f; $($rest:tt)*) => {
        $crate::list_lines!([$($done,)* ListLine::Blend,] $($rest)*)
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! list_test {
    (depth complexity <= i) => {
        ListTest::FitsSegment
    };
    (depth complexity > i) => {
        ListTest::Overflows
    };
    (depth complexity <= i or i = max) => {
        ListTest::FitsSegmentOrLast
    };
    (depth <= min depth) => {
        ListTest::NotBehindMin(Key::Depth)
    };
    ((depth, id) <= (min depth, min id)) => {
        ListTest::NotBehindMin(Key::DepthAndId)
    };
    (f is of a proxy) => {
        ListTest::IsProxy
    };
}
