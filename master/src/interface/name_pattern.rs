//! Names of variables with `*` for any text.

/// Whether `name` is one that `pattern` stands for.
pub fn matches(pattern: &str, name: &str) -> bool {
    let Some((begin, rest)) = pattern.split_once('*') else {
        return pattern == name;
    };
    let Some(name) = name.strip_prefix(begin) else {
        return false;
    };
    // The star may stand for any part of what is left.
    let ends = name.char_indices().map(|(index, _)| index).chain([name.len()]);
    ends.into_iter().any(|end| matches(rest, &name[end..]))
}

#[cfg(test)]
mod tests {
    use super::matches;

    #[test]
    fn a_star_stands_for_any_text() {
        for (pattern, name, expected) in [
            ("position", "position", true),
            ("position", "positions", false),
            ("*.yaw", "wheelset[1].yaw", true),
            ("*.yaw", "wheelset[1].yaw.rate", false),
            ("wheelset[*].left.*", "wheelset[12].left.patch[1].angle", true),
            ("wheelset[*].left.*", "wheelset[12].right.unloading", false),
            ("*", "", true),
            ("a*a", "a", false),
        ] {
            assert_eq!(matches(pattern, name), expected, "{pattern} {name}");
        }
    }
}
