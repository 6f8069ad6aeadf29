"""HTML pages and plots shared by all reports."""
