namespace RayCaster.Cli;

/// <summary>Ends a command whose errors are printed already.</summary>
internal sealed class ReportedException(string message) : Exception(message);
