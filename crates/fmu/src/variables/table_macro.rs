//! The macro that makes of one table all that the FMU and the physics need of its variables.

/// Says the variables of one thing once: their names, units, start values, bounds and descriptions.
///
/// ```
/// use fmu::{Declaration, Variables, Scope};
///
/// fmu::variables! {
///     /// How the running surface exchanges heat.
///     #[derive(Copy)]
///     pub struct Surface: parameter {
///         /// Heat transfer coefficient of the running surface to the air
///         convection: "surface.convection", WATT_PER_SQUARE_METRE_KELVIN = 6.0, 0.0..;
///         /// Share of the sunlight that is absorbed
///         absorptivity: "solar.absorptivity", ONE = 0.75, 0.0..=1.0;
///     }
/// }
///
/// // The struct of plain values is what the physics knows.
/// let heat_flux = |surface: &Surface, rise: f64| surface.convection * rise;
///
/// let mut declaration = Declaration::default();
/// let handles = Surface::declare(&mut declaration, "");
/// let mut values = declaration.start_values().clone();
/// assert_eq!(heat_flux(&Surface::read(&handles, &values), 10.0), 60.0);
///
/// Surface { convection: 7.0, absorptivity: 0.5 }.write(&handles, &mut values);
/// assert_eq!(values[handles.convection], 7.0);
/// ```
///
/// # A table
/// `struct NAME: USE`, where the use is `parameter` (fixed after the initialisation), `tunable`
/// (a parameter that may change between steps), `input` or `output`; a table of groups only has
/// no use of its own. It becomes
/// - the struct of plain values, `Clone`, `Debug`, `PartialEq` and what the attributes add;
/// - [`Handles<NAME>`](crate::Handles), with a handle for each value;
/// - `NAME::declare(declaration, scope)`, which declares the variables in the order of the rows;
///   the [`Scope`](crate::Scope) is what their names begin with;
/// - [`NAME::read(handles, values)` and `value.write(handles, values)`](crate::Variables).
///
/// # A row
/// The first paragraph of the doc comment is the description of the variable, without its full stop;
/// `{}` in it is what the scope is about. Then `field: "name"`, after which comes
///
/// | kind | example | value |
/// |---|---|---|
/// | Real, with its constant in [`unit`](crate::unit) | `METRE = 0.1` | `f64` |
/// | Integer | `i32 = 4, 1..=8` | `i32` |
/// | Boolean | `bool = true` | `bool` |
/// | String | `String = "AS60"` | `String` |
/// | choice, an enumeration of [`choices!`](crate::choices!) | `choice(Brake) = Brake::Air` | `Brake` |
/// | file in the resources, unless a name is given | `file("track.toml")` | [`ResourceFile`](crate::ResourceFile) |
/// | group: another table under the name, and what it is about | `group(Motion) = "the train"` | `Motion` |
/// | groups | `["left", "right"], group(Wheel) = ["left wheel", "right wheel"]` | `[Wheel; 2]` |
///
/// The bounds of a number are a range, `0.0..` or `0.0..=1.0`, or [`above(0.0)`](crate::above),
/// which excludes its smallest value. A group with the empty name stands where its table stands.
///
/// An output has no start value, since the model computes it:
///
/// ```compile_fail
/// fmu::variables! {
///     /// What the model computes.
///     pub struct Outputs: output {
///         /// Chainage
///         position: "position", METRE = 0.0;
///     }
/// }
/// ```
#[macro_export]
macro_rules! variables {
    ($(
        $(#[$attribute:meta])*
        $visibility:vis struct $table:ident $(: $usage:ident)? { $($rows:tt)+ }
    )+) => {$(
        $crate::variable_table! {
            (declaration, scope, [$($usage)?], $(#[$attribute])* $visibility $table) [] $($rows)+
        }
    )+};
}

/// Turns the rows of [`variables!`](crate::variables!) into code.
///
/// One row after the other becomes `{ tag field: type = expression that declares it }` in a list;
/// the tag is `real` or `other`.
#[doc(hidden)]
#[macro_export]
macro_rules! variable_table {
    (
        ($declaration:ident, $scope:ident, [$usage:ident], $($head:tt)*) [$($done:tt)*]
        $(#[doc = $doc:literal])+
        $field:ident: $name:literal, bool $(= $start:expr)?;
        $($rows:tt)*
    ) => {
        $crate::variable_table! {
            ($declaration, $scope, [$usage], $($head)*)
            [$($done)* { other $(#[doc = $doc])+ $field: bool = $declaration
                .boolean($scope.name($name), $scope.description(&[$($doc),+]))
                .$usage($($start)?) }]
            $($rows)*
        }
    };
    (
        ($declaration:ident, $scope:ident, [$usage:ident], $($head:tt)*) [$($done:tt)*]
        $(#[doc = $doc:literal])+
        $field:ident: $name:literal, i32 $(= $start:expr)? $(, $bounds:expr)?;
        $($rows:tt)*
    ) => {
        $crate::variable_table! {
            ($declaration, $scope, [$usage], $($head)*)
            [$($done)* { other $(#[doc = $doc])+ $field: i32 = $declaration
                .integer($scope.name($name), $scope.description(&[$($doc),+]))
                $(.within($bounds))?
                .$usage($($start)?) }]
            $($rows)*
        }
    };
    (
        ($declaration:ident, $scope:ident, [$usage:ident], $($head:tt)*) [$($done:tt)*]
        $(#[doc = $doc:literal])+
        $field:ident: $name:literal, String $(= $start:expr)?;
        $($rows:tt)*
    ) => {
        $crate::variable_table! {
            ($declaration, $scope, [$usage], $($head)*)
            [$($done)* { other $(#[doc = $doc])+ $field: String = $declaration
                .text($scope.name($name), $scope.description(&[$($doc),+]))
                .$usage($($start)?) }]
            $($rows)*
        }
    };
    (
        ($declaration:ident, $scope:ident, [$usage:ident], $($head:tt)*) [$($done:tt)*]
        $(#[doc = $doc:literal])+
        $field:ident: $name:literal, choice($choice:ty) $(= $start:expr)?;
        $($rows:tt)*
    ) => {
        $crate::variable_table! {
            ($declaration, $scope, [$usage], $($head)*)
            [$($done)* { other $(#[doc = $doc])+ $field: $choice = $declaration
                .text($scope.name($name), $scope.description(&[$($doc),+]))
                .one_of(<$choice as $crate::Choice>::TEXTS)
                .$usage($($crate::Choice::text($start))?) }]
            $($rows)*
        }
    };
    (
        ($declaration:ident, $scope:ident, [$usage:ident], $($head:tt)*) [$($done:tt)*]
        $(#[doc = $doc:literal])+
        $field:ident: $name:literal, file($default:expr);
        $($rows:tt)*
    ) => {
        $crate::variable_table! {
            ($declaration, $scope, [$usage], $($head)*)
            [$($done)* { other $(#[doc = $doc])+ $field: $crate::ResourceFile = $crate::FileHandle {
                parameter: $declaration
                    .text($scope.name($name), $scope.description(&[$($doc),+]))
                    .$usage(""),
                default: $default,
            } }]
            $($rows)*
        }
    };
    (
        ($declaration:ident, $scope:ident, $usage:tt, $($head:tt)*) [$($done:tt)*]
        $(#[doc = $doc:literal])+
        $field:ident: $name:literal, group($group:ty) $(= $subject:literal)?;
        $($rows:tt)*
    ) => {
        $crate::variable_table! {
            ($declaration, $scope, $usage, $($head)*)
            [$($done)* { other $(#[doc = $doc])+ $field: $group = <$group>::declare(
                $declaration,
                $scope.group($name)$(.about($subject))?,
            ) }]
            $($rows)*
        }
    };
    (
        ($declaration:ident, $scope:ident, $usage:tt, $($head:tt)*) [$($done:tt)*]
        $(#[doc = $doc:literal])+
        $field:ident: [$($name:literal),+], group($group:ty) = [$($subject:literal),+];
        $($rows:tt)*
    ) => {
        $crate::variable_table! {
            ($declaration, $scope, $usage, $($head)*)
            [$($done)* { other $(#[doc = $doc])+ $field: [$group; [$($name),+].len()] = [$(
                <$group>::declare($declaration, $scope.group($name).about($subject))
            ),+] }]
            $($rows)*
        }
    };
    // After all kinds that a word of Rust or of this grammar names comes that of the units.
    (
        ($declaration:ident, $scope:ident, [$usage:ident], $($head:tt)*) [$($done:tt)*]
        $(#[doc = $doc:literal])+
        $field:ident: $name:literal, $unit:ident $(= $start:expr)? $(, $bounds:expr)?;
        $($rows:tt)*
    ) => {
        $crate::variable_table! {
            ($declaration, $scope, [$usage], $($head)*)
            [$($done)* { real $(#[doc = $doc])+ $field: f64 = $declaration
                .real($scope.name($name), $crate::unit::$unit, $scope.description(&[$($doc),+]))
                $(.within($bounds))?
                .$usage($($start)?) }]
            $($rows)*
        }
    };
    // All rows are taken.
    (
        (
            $declaration:ident, $scope:ident, $usage:tt,
            $(#[$attribute:meta])* $visibility:vis $table:ident
        )
        [$({ $tag:ident $(#[$doc:meta])+ $field:ident: $type:ty = $handle:expr })+]
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Debug, PartialEq)]
        $visibility struct $table {
            $($(#[$doc])+ $visibility $field: $type,)+
        }

        const _: () = {
            /// Handles of the variables of a table.
            #[derive(Clone, Copy, Debug)]
            $visibility struct TableHandles {
                $($(#[$doc])+ $visibility $field: $crate::Handles<$type>,)+
            }

            impl $table {
                /// Declares the variables of the table in the order of its rows.
                $visibility fn declare(
                    $declaration: &mut $crate::Declaration,
                    scope: impl Into<$crate::Scope>,
                ) -> TableHandles {
                    #[allow(unused_imports, reason = "some table has bounds of this kind")]
                    use $crate::above;
                    let $scope: $crate::Scope = scope.into();
                    TableHandles { $($field: $handle,)+ }
                }
            }

            $crate::table_access! { $table TableHandles $({ $tag $field })+ }
        };
    };
    // No kind of row fits, or the table has no use.
    ($head:tt $done:tt $($rows:tt)+) => {
        compile_error!(concat!("`fmu::variables!` cannot read: ", stringify!($($rows)+)));
    };
}

/// How the values of a table are read and written.
///
/// Real variables that are declared one after the other have references one after the other, so a
/// table of nothing else is copied at once.
#[doc(hidden)]
#[macro_export]
macro_rules! table_access {
    ($table:ident $handles:ident { real $first:ident } $({ real $field:ident })*) => {
        impl $crate::Variables for $table {
            type Handles = $handles;

            #[inline]
            fn read(handles: &$handles, values: &$crate::Values) -> Self {
                let [$first $(, $field)*] = values[$crate::Reals::from_first(handles.$first)];
                Self { $first $(, $field)* }
            }

            #[inline]
            fn write(&self, handles: &$handles, values: &mut $crate::Values) {
                let reals = $crate::Reals::from_first(handles.$first);
                values[reals] = [self.$first $(, self.$field)*];
            }
        }
    };
    ($table:ident $handles:ident $({ $tag:ident $field:ident })+) => {
        impl $crate::Variables for $table {
            type Handles = $handles;

            #[inline]
            fn read(handles: &$handles, values: &$crate::Values) -> Self {
                Self { $($field: $crate::Variables::read(&handles.$field, values),)+ }
            }

            #[inline]
            fn write(&self, handles: &$handles, values: &mut $crate::Values) {
                $($crate::Variables::write(&self.$field, &handles.$field, values);)+
            }
        }
    };
}
