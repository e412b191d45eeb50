"""Answer for a user's part: verdict, number to design with, margin, limits."""
