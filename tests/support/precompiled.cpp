// A precompiled header belongs to a target with a source; main() comes with Catch2WithMain.
