"""What formula and reference of a case both assume, by subject."""
