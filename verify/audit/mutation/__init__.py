"""What the suite catches: references, formulas, judging and finite elements changed on purpose."""
