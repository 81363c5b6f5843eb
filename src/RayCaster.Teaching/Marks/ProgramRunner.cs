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
    private static readonly TimeSpan gracePeriod = TimeSpan.FromSeconds(10);

    /// <summary>Runs a command to its end, or until soon after the time limit.</summary>
    public ProgramRun Run(
        IReadOnlyList<string> command, string folder, string temporary, ProgramLimits limits, TimeSpan time, CancellationToken cancellation)
    {
        var wrapped = containment.Wrap(command, limits, time);
        var start = new ProcessStartInfo(wrapped[0], wrapped.Skip(1))
        {
            WorkingDirectory = folder,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        var run = Guid.NewGuid().ToString("N");
        start.Environment[RunVariable] = run;
        foreach (var name in (ReadOnlySpan<string>)["TMPDIR", "TMP", "TEMP"]) start.Environment[name] = temporary;
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
    private static ProgramEnd Watch(Process process, PrintedText printed, ProgramLimits limits, TimeSpan time, CancellationToken cancellation)
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
            if (tree.Count > limits.Processes) return ProgramEnd.TooManyProcesses;
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
            var tree = containment.HasOwnTree ? [] : ProcessTree.Of(process.Id);
            process.Kill(entireProcessTree: !OperatingSystem.IsLinux());
            foreach (var (id, _, _) in tree) KillOne(id);
            process.WaitForExit(gracePeriod);
        }
        if (containment.HasOwnTree) return;
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
