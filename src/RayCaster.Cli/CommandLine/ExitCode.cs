namespace RayCaster.Cli;

/// <summary>
/// Exit codes of the process. 1 means only "the answer is no", so scripts can distinguish a wrong picture from a failed run. A signal gives 128 plus
/// its number, as in a shell.
/// </summary>
internal static class ExitCode
{
    public const int Done = 0;
    public const int No = 1;
    public const int Failed = 2;
    public const int InternalError = 70;
    public const int HungUp = 129;
    public const int Interrupted = 130;
    public const int Terminated = 143;
    public const int OutOfTime = 152;
}
