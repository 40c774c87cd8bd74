"""What happens to designs outside the window: autosave and recovery, backups, locks, recent files, other windows."""
