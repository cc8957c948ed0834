use cagd::bezier::tableaux;
use cagd::check::tableau::Tableau;

fn tableau() -> Tableau {
    tableaux::cubic(answer::ROUND).tableau
}

fn probes() -> Vec<String> {
    tableau().trace(answer::TABLEAU)
}

#[test]
fn the_control_points_are_those_given() {
    tableau().judge_column(answer::TABLEAU, 0);
}

/// Why: a test for each step tells in which one the first slip is.
#[test]
fn first_step() {
    tableau().judge_column(answer::TABLEAU, 1);
}

/// Why: a test for each step tells in which one the first slip is.
#[test]
fn second_step() {
    tableau().judge_column(answer::TABLEAU, 2);
}

#[test]
fn last_step() {
    tableau().judge_column(answer::TABLEAU, 3);
}
