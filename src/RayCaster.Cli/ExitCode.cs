namespace RayCaster.Cli;

/// <summary>
/// What the process returns. 1 is kept for "the answer is no", so that "wrong picture" and "did not run" can be told apart; a signal
/// gives 128 and its number, as in a shell.
/// </summary>
internal static class ExitCode
{
    public const int Done = 0;
    public const int No = 1;
    public const int CouldNot = 2;
    public const int InternalError = 70;
    public const int HungUp = 129;
    public const int Interrupted = 130;
    public const int Terminated = 143;
}
