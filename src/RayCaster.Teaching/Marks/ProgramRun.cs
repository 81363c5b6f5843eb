using static System.FormattableString;

namespace RayCaster.Teaching;

/// <summary>How a student's program ended.</summary>
internal enum ProgramEnd
{
    Exited, // by itself, with an exit code
    NotStarted,
    OutOfTime, TooMuchOutput, TooMuchMemory, TooManyProcesses, // it was ended with all its processes
}

/// <summary>The result of a run of a student's program.</summary>
/// <param name="Printed">The end of its output, standard output and standard error together.</param>
internal sealed record ProgramRun(ProgramEnd End, int ExitCode, string Printed)
{
    public bool IsDone => End == ProgramEnd.Exited && ExitCode == 0;

    public string InWords(ProgramLimits limits, TimeSpan time) => End switch
    {
        ProgramEnd.NotStarted => $"cannot be started: {Printed}",
        ProgramEnd.OutOfTime => Invariant($"out of time after {time.TotalSeconds:0.#} s"),
        ProgramEnd.TooMuchOutput => Invariant($"printed more than {limits.OutputBytes / 1e6:0.#} MB"),
        ProgramEnd.TooMuchMemory => Invariant($"held more than {limits.MemoryBytes / 1e6:0} MB of memory"),
        ProgramEnd.TooManyProcesses => Invariant($"started more than {limits.Processes} processes"),
        _ when ExitCode > 128 => Invariant($"crashed (exit code {ExitCode}, signal {ExitCode - 128})"),
        _ when ExitCode != 0 => Invariant($"ended with exit code {ExitCode}"),
        _ => "succeeded",
    };
}
