"""What the validation cases share: reading a run, measuring curves, verdicts, pictures, and starting runs."""
