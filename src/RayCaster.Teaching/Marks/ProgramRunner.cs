using System.Collections.Concurrent;
using System.ComponentModel;
using System.Diagnostics;

namespace RayCaster.Teaching;

/// <summary>Runs an untrusted program, and ends it with all its processes when it exceeds a limit.</summary>
/// <param name="containment">The limits that the system enforces.</param>
internal sealed class ProgramRunner(Containment containment)
{
    private const int PollInterval = 10; // milliseconds
    private const int TreeInterval = 100; // milliseconds between two readings of the whole tree, if the number of processes does not grow
    private const string RunVariable = "RAYCASTER_SUBMISSION"; // in the environment of all processes of a run
    private const int TryAgain = 11; // EAGAIN: there are too many processes now, perhaps of another submission
    private static readonly string[] variables = ["PATH", "LANG"];
    private static readonly string[] windowsVariables =
        ["SystemRoot", "SystemDrive", "windir", "ComSpec", "PATHEXT", "ProgramFiles", "ProgramFiles(x86)", "ProgramData"];
    private static readonly TimeSpan gracePeriod = TimeSpan.FromSeconds(10);

    private readonly ConcurrentBag<(long Start, long End)> multiplied = [];

    /// <summary>Whether programs cannot change the files of others.</summary>
    public bool IsApart => containment.IsApart;

    /// <summary>Whether a program that started too many processes ran at some time between these.</summary>
    public bool HasMultiplied(long start, long end) => multiplied.Any(other => other.Start < end && start < other.End);

    /// <summary>Runs a command to its end, or until soon after the time limit.</summary>
    public ProgramRun Run(
        IReadOnlyList<string> command, ProgramPlace place, ProgramLimits limits, TimeSpan time, CancellationToken cancellation)
    {
        var began = Stopwatch.GetTimestamp();
        var run = RunOnce(command, place, limits, time, cancellation);
        if (run.End == ProgramEnd.TooManyProcesses) multiplied.Add((began, Stopwatch.GetTimestamp()));
        return run;
    }

    private ProgramRun RunOnce(
        IReadOnlyList<string> command, ProgramPlace place, ProgramLimits limits, TimeSpan time, CancellationToken cancellation)
    {
        var wrapped = containment.Wrap(command, place, limits, time);
        var start = new ProcessStartInfo(wrapped[0], wrapped.Skip(1))
        {
            WorkingDirectory = place.Folder,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        var run = Guid.NewGuid().ToString("N");
        SetEnvironment(start.Environment, place.Temporary, limits);
        start.Environment[RunVariable] = run;
        try
        {
            using var process = Start(start);
            process.StandardInput.Close();
            var printed = new PrintedText(process, limits.OutputBytes);
            var end = Watch(process, printed, limits, time, cancellation);
            End(process, run);
            printed.WaitForEnd(gracePeriod);
            cancellation.ThrowIfCancellationRequested();
            return new(end, end == ProgramEnd.Exited ? process.ExitCode : 0, printed.Text);
        }
        catch (Exception e) when (e is Win32Exception or IOException)
        {
            return new(ProgramEnd.NotStarted, 0, e.Message);
        }
    }

    /// <summary>Leaves few variables of the teacher's environment, which may hold passwords.</summary>
    private static void SetEnvironment(IDictionary<string, string?> environment, string temporary, ProgramLimits limits)
    {
        var kept = variables.Concat(OperatingSystem.IsWindows() ? windowsVariables : []).Concat(limits.Environment).ToHashSet(
            OperatingSystem.IsWindows() ? StringComparer.OrdinalIgnoreCase : StringComparer.Ordinal);
        foreach (var name in environment.Keys.ToArray())
            if (!kept.Contains(name) && (!name.StartsWith("DOTNET_", StringComparison.Ordinal) || name == "DOTNET_CLI_HOME"))
                environment.Remove(name);
        foreach (var name in (ReadOnlySpan<string>)["HOME", "TMPDIR", "TMP", "TEMP", "USERPROFILE"]) environment[name] = temporary;
        foreach (var name in (ReadOnlySpan<string>)["DOTNET_NOLOGO", "DOTNET_CLI_TELEMETRY_OPTOUT"]) environment[name] = "1";
    }

    /// <summary>Starts a process. Tries again while another submission has too many processes; that one is ended soon.</summary>
    private static Process Start(ProcessStartInfo start)
    {
        var since = Stopwatch.GetTimestamp();
        while (true)
        {
            try
            {
                return Process.Start(start)!;
            }
            catch (Win32Exception e) when (e.NativeErrorCode == TryAgain && Stopwatch.GetElapsedTime(since) < gracePeriod)
            {
                Thread.Sleep(PollInterval);
            }
        }
    }

    /// <remarks>
    /// A program that starts more and more processes doubles them within milliseconds. So the number of all tasks is read often; reading the whole
    /// tree takes longer and is done seldom.
    /// </remarks>
    private ProgramEnd Watch(Process process, PrintedText printed, ProgramLimits limits, TimeSpan time, CancellationToken cancellation)
    {
        var start = Stopwatch.GetTimestamp();
        var (tasks, looked) = (ProcessTree.TaskCount(), start);
        while (!process.WaitForExit(PollInterval))
        {
            if (cancellation.IsCancellationRequested || Stopwatch.GetElapsedTime(start) > time) return ProgramEnd.OutOfTime;
            if (printed.IsTooLong) return ProgramEnd.TooMuchOutput;
            var now = ProcessTree.TaskCount();
            if (now - tasks < limits.Processes && Stopwatch.GetElapsedTime(looked).TotalMilliseconds < TreeInterval) continue;
            var tree = ProcessTree.Of(process.Id);
            if (tree.Count - containment.Helpers > limits.Processes) return ProgramEnd.TooManyProcesses;
            if (tree.Sum(member => member.Memory) > limits.MemoryBytes) return ProgramEnd.TooMuchMemory;
            (tasks, looked) = (now, Stopwatch.GetTimestamp());
        }
        return printed.IsTooLong ? ProgramEnd.TooMuchOutput : ProgramEnd.Exited;
    }

    /// <summary>
    /// Ends the process and its descendants, then each process with the run's number in its environment: one that left its parent has it, too.
    /// </summary>
    /// <remarks>Process.Kill would read all processes once for each process of the tree, which takes seconds for a fork bomb on Linux.</remarks>
    private void End(Process process, string run)
    {
        if (!process.HasExited)
        {
            var tree = containment.IsApart ? [] : ProcessTree.Of(process.Id);
            process.Kill(entireProcessTree: !OperatingSystem.IsLinux());
            foreach (var (id, _, _) in tree) KillOne(id);
            process.WaitForExit(gracePeriod);
        }
        if (containment.IsApart) return;
        var since = Stopwatch.GetTimestamp();
        while (ProcessTree.WithVariable(RunVariable, run).Count(KillOne) > 0 && Stopwatch.GetElapsedTime(since) < gracePeriod) { }
    }

    private static bool KillOne(int id)
    {
        try
        {
            using var process = Process.GetProcessById(id);
            process.Kill();
            return true;
        }
        catch (Exception e) when (e is ArgumentException or InvalidOperationException or Win32Exception)
        {
            return false; // it has ended already
        }
    }

    /// <summary>What a program prints: all bytes are counted, the last characters are kept.</summary>
    private sealed class PrintedText
    {
        private const int Kept = 8000; // characters

        private readonly StringBuilder text = new();
        private readonly long maxLength;
        private readonly Task reading;
        private long length;

        public PrintedText(Process process, long maxLength)
        {
            this.maxLength = maxLength;
            reading = Task.WhenAll(Read(process.StandardOutput.BaseStream), Read(process.StandardError.BaseStream));
        }

        public bool IsTooLong => Interlocked.Read(ref length) > maxLength;

        public string Text
        {
            get
            {
                lock (text) return PrintableText.Of(text.ToString().ReplaceLineEndings("\n"), ofLines: true).Trim();
            }
        }

        /// <summary>Waits for the end of the output, at most some time: a process that escaped may keep the pipe open for ever.</summary>
        public void WaitForEnd(TimeSpan time) => reading.Wait(time);

        private async Task Read(Stream stream)
        {
            var bytes = new byte[1 << 16];
            var characters = new char[bytes.Length + 1]; // one that was cut before, and the rest
            var decoder = Encoding.UTF8.GetDecoder(); // keeps a character that is cut until the next read
            try
            {
                for (int count; (count = await stream.ReadAsync(bytes).ConfigureAwait(false)) > 0 && !IsTooLong;)
                    Add(count, characters.AsSpan(0, decoder.GetChars(bytes, 0, count, characters, 0)));
            }
            catch (Exception e) when (e is IOException or ObjectDisposedException)
            {
                // The other end has closed the pipe.
            }
        }

        private void Add(int bytes, ReadOnlySpan<char> characters)
        {
            Interlocked.Add(ref length, bytes);
            lock (text)
            {
                text.Append(characters);
                if (text.Length > 2 * Kept) text.Remove(0, text.Length - Kept);
            }
        }
    }
}
