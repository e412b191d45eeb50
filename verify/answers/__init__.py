"""What a user's parameters mean for the part: verdict, number to design with, margin, limits."""
