"""HTML pages and plots that all reports share."""
