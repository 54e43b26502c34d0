//! Tables for the terminal.

use std::fmt::Write;

/// Formats rows under a head. The first column is flush left, all others are flush right.
pub fn table<const N: usize>(head: [&str; N], rows: &[[String; N]]) -> String {
    let width = |text: &str| text.chars().count();
    let widths: [usize; N] =
        std::array::from_fn(|j| rows.iter().map(|row| width(&row[j])).fold(width(head[j]), usize::max));
    let mut text = String::new();
    let mut line = |cells: [&str; N]| {
        for (j, cell) in cells.iter().enumerate() {
            let pad = " ".repeat(widths[j] - width(cell));
            let _ = if j == 0 { write!(text, "{cell}{pad}") } else { write!(text, "   {pad}{cell}") };
        }
        text.push('\n');
    };
    line(head);
    line(widths.map(|w| "─".repeat(w)).each_ref().map(String::as_str));
    for row in rows {
        line(row.each_ref().map(String::as_str));
    }
    text
}
