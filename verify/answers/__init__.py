"""Answer of `check` for a user's part: verdict, design value, margin and limits."""
