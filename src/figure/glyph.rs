//! Characters of labels: their widths, and the commands that name them.

/// Advance widths of TeX Gyre Pagella, the font of the book, in hundredths of the size, from U+0020 to U+007E.
///
/// Times and its kin, which a reader without that font gets, are narrower.
#[rustfmt::skip]
const UPRIGHT: [u8; 95] = [
    25, 28, 37, 50, 50, 84, 78, 21, 46, 46, 39, 76, 25, 33, 25, 49, 50, 50, 50, 50, 50, 50, 50, 50, 50, 50, 25, 25, 77, 76, 77, 44,
    75, 78, 61, 71, 77, 61, 56, 76, 83, 34, 33, 73, 61, 95, 83, 79, 60, 79, 67, 52, 61, 78, 72, 100, 67, 67, 67, 43, 49, 43, 61, 50,
    33, 50, 55, 44, 61, 48, 33, 56, 58, 29, 23, 56, 29, 88, 58, 55, 60, 56, 40, 42, 33, 60, 56, 83, 52, 56, 50, 44, 21, 44, 61,
];
/// The same for the italic.
#[rustfmt::skip]
const ITALIC: [u8; 95] = [
    25, 33, 50, 50, 50, 89, 78, 23, 46, 46, 39, 76, 25, 33, 25, 49, 50, 50, 50, 50, 50, 50, 50, 50, 50, 50, 25, 25, 77, 76, 77, 50,
    75, 72, 61, 67, 78, 61, 56, 72, 78, 33, 33, 67, 56, 94, 78, 78, 61, 78, 67, 56, 61, 78, 72, 94, 72, 67, 67, 43, 49, 43, 61, 50,
    33, 44, 46, 41, 50, 39, 28, 50, 50, 28, 28, 44, 28, 78, 56, 44, 50, 46, 39, 39, 33, 56, 50, 72, 50, 50, 44, 44, 21, 44, 61,
];

/// How wide a character is, in sizes.
pub(super) fn advance(c: char, italic: bool) -> f64 {
    if let ' '..='~' = c {
        let table = if italic { &ITALIC } else { &UPRIGHT };
        return f64::from(table[c as usize - ' ' as usize]) / 100.0;
    }
    // These come from whatever font has them.
    match c {
        '\u{200b}' => 0.0,
        '\u{2009}' => 0.2,
        '·' | '’' | '′' => 0.3,
        '→' | '↦' | '∞' | '…' | '\u{2003}' => 1.0,
        '−' | '≤' | '≥' | '≠' | '≈' | '±' | '×' | '∈' | '∘' | 'Α'..='Ω' => 0.77,
        _ => 0.58,
    }
}

/// What a symbol is to its neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Italic,
    Upright,
    Binary,
    Relation,
    Space,
}

/// The character that a command names.
pub(super) fn symbol(name: &str) -> Option<(&'static str, Kind)> {
    let greek = |symbol| Some((symbol, Kind::Italic));
    let upright = |symbol| Some((symbol, Kind::Upright));
    let binary = |symbol| Some((symbol, Kind::Binary));
    let relation = |symbol| Some((symbol, Kind::Relation));
    match name {
        "alpha" => greek("α"),
        "beta" => greek("β"),
        "gamma" => greek("γ"),
        "delta" => greek("δ"),
        "epsilon" | "varepsilon" => greek("ε"),
        "zeta" => greek("ζ"),
        "eta" => greek("η"),
        "theta" => greek("θ"),
        "kappa" => greek("κ"),
        "lambda" => greek("λ"),
        "mu" => greek("μ"),
        "nu" => greek("ν"),
        "xi" => greek("ξ"),
        "pi" => greek("π"),
        "rho" => greek("ρ"),
        "sigma" => greek("σ"),
        "tau" => greek("τ"),
        "phi" | "varphi" => greek("φ"),
        "chi" => greek("χ"),
        "psi" => greek("ψ"),
        "omega" => greek("ω"),
        "ell" => greek("ℓ"),
        "Gamma" => upright("Γ"),
        "Delta" => upright("Δ"),
        "Lambda" => upright("Λ"),
        "Pi" => upright("Π"),
        "Sigma" => upright("Σ"),
        "Phi" => upright("Φ"),
        "Omega" => upright("Ω"),
        "infty" => upright("∞"),
        "ldots" | "dots" => upright("…"),
        "prime" => upright("′"),
        "circ" => upright("∘"),
        "partial" => upright("∂"),
        "|" => upright("‖"),
        "{" => upright("{"),
        "}" => upright("}"),
        "cdot" => binary("·"),
        "times" => binary("×"),
        "pm" => binary("±"),
        "le" => relation("≤"),
        "ge" => relation("≥"),
        "ne" => relation("≠"),
        "approx" => relation("≈"),
        "in" => relation("∈"),
        "to" => relation("→"),
        "mapsto" => relation("↦"),
        "," => Some(("\u{2009}", Kind::Space)),
        ";" | "quad" => Some(("\u{2003}", Kind::Space)),
        _ => None,
    }
}
