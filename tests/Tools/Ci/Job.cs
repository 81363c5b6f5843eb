using System.Text.Json;
using System.Text.Json.Serialization;
using System.Text.RegularExpressions;

namespace RayCaster.Ci;

/// <summary>A row of jobs.json.</summary>
/// <param name="Name">What it is called, also on the command line.</param>
/// <param name="Command">A command for bash. <c>$REPORT</c> in it stands for the options with which "dotnet test" writes its reports.</param>
/// <param name="Minutes">How long it may take.</param>
internal sealed partial record Job(string Name, string Command, double Minutes)
{
    /// <summary>Jobs of a group run one after another, and groups beside each other; a job without a group runs before them, alone.</summary>
    public string? Group { get; init; }

    /// <summary>Whether it runs once a week only.</summary>
    public bool Weekly { get; init; }

    /// <summary>Files and folders: if it has some, it runs only after a change in one of them, or of a file that its command names.</summary>
    public string[] When { get; init; } = [];

    /// <summary>A condition for bash: the job runs only where it holds.</summary>
    public string? If { get; init; }

    /// <summary>Environment variables.</summary>
    public Dictionary<string, string> Environment { get; init; } = [];

    /// <summary>How much memory each of its processes may take.</summary>
    public int Megabytes { get; init; } = 1024;

    /// <summary>Why it may take more than others.</summary>
    public string? Because { get; init; }

    /// <summary>How many test programs must leave a report.</summary>
    public int Reports { get; init; } = Command.Contains("$REPORT") ? 1 : 0;

    /// <summary>The files and folders of the project that the command names.</summary>
    [JsonIgnore]
    public IEnumerable<string> Paths => PathPattern().Matches(Command).Select(match => match.Value);

    /// <summary>Whether it is to run.</summary>
    /// <param name="week">Whether this is the week's run.</param>
    /// <param name="changed">The files that have changed; null if nobody knows.</param>
    public bool IsDue(bool week, IReadOnlyCollection<string>? changed)
    {
        if (week || Weekly) return week;
        return When.Length == 0 || changed is null || When.Concat(Paths).Concat(common).Any(path => changed.Any(file => IsIn(file, path)));
    }

    /// <summary>The jobs of a table.</summary>
    public static IReadOnlyList<Job> ReadTable(string json)
    {
        var jobs = JsonSerializer.Deserialize<Job[]>(json, options) ?? throw new InvalidDataException("jobs.json has no jobs");
        foreach (var job in jobs)
        {
            if (jobs.Count(other => other.Name == job.Name) > 1) throw new InvalidDataException($"jobs.json has two jobs {job.Name}");
            if (job.Minutes <= 0) throw new InvalidDataException($"jobs.json: {job.Name} has no time");
            if (job.Megabytes > 1024 && job.Because is null)
                throw new InvalidDataException($"jobs.json: {job.Name} may take more memory than others: \"because\" says why");
        }
        return jobs;
    }

    // A change of these may change everything.
    private static readonly string[] common = ["Directory.Build.props", "global.json", "tests/Directory.Build.props"];

    private static readonly JsonSerializerOptions options = new(JsonSerializerDefaults.Web)
    {
        ReadCommentHandling = JsonCommentHandling.Skip,
        AllowTrailingCommas = true,
        UnmappedMemberHandling = JsonUnmappedMemberHandling.Disallow,
        RespectRequiredConstructorParameters = true,
        RespectNullableAnnotations = true,
    };

    private static bool IsIn(string file, string path) => file == path || file.StartsWith(path.TrimEnd('/') + '/', StringComparison.Ordinal);

    [GeneratedRegex(@"(?<![\w./$*-])(?:src|tests|docs|scenes)/[\w./-]*\w")]
    private static partial Regex PathPattern();
}
