use cagd::bezier::tableaux;
use cagd::check::tableau::Tableau;

fn tableau() -> Tableau {
    tableaux::cubic_blossom(answer::ROUND).tableau
}

fn probes() -> Vec<String> {
    tableau().trace(answer::TABLEAU)
}

#[test]
fn the_given_values_stay() {
    tableau().judge_column(answer::TABLEAU, 0);
}

/// Why: a test for each argument tells at which one the first slip is.
#[test]
fn first_argument() {
    tableau().judge_column(answer::TABLEAU, 1);
}

/// Why: a test for each argument tells at which one the first slip is.
#[test]
fn second_argument() {
    tableau().judge_column(answer::TABLEAU, 2);
}

#[test]
fn last_argument() {
    tableau().judge_column(answer::TABLEAU, 3);
}
