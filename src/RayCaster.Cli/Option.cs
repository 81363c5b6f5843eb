namespace RayCaster.Cli;

/// <summary>An option of the command line. It has the same meaning for all commands.</summary>
internal sealed class Option
{
    /// <summary>All options: each adds itself. A word can be parsed before the command is known.</summary>
    public static readonly List<Option> All = [];

    public static readonly Option Output = new("--output", "-o");
    public static readonly Option Format = new("--format");
    public static readonly Option Size = new("--size", "-s");
    public static readonly Option Rows = new("--rows");
    public static readonly Option Resume = new("--resume", takesValue: false);
    public static readonly Option Missing = new("--missing", takesValue: false);
    public static readonly Option Frames = new("--frames");
    public static readonly Option Only = new("--only");
    public static readonly Option Threads = new("--threads", "-t");
    public static readonly Option Map = new("--map");
    public static readonly Option Scene = new("--scene");
    public static readonly Option Reference = new("--reference");
    public static readonly Option Hint = new("--hint");
    public static readonly Option Done = new("--done");
    public static readonly Option For = new("--for");
    public static readonly Option Require = new("--require");
    public static readonly Option Mistake = new("--mistake");
    public static readonly Option Seed = new("--seed");
    public static readonly Option Mine = new("--mine");
    public static readonly Option Port = new("--port");
    public static readonly Option Ledger = new("--ledger", takesValue: false);
    public static readonly Option Plain = new("--plain", takesValue: false);
    public static readonly Option Measures = new("--measures", takesValue: false);
    public static readonly Option Everything = new("--all", takesValue: false);
    public static readonly Option Json = new("--json", takesValue: false);
    public static readonly Option Open = new("--open");
    public static readonly Option Solution = new("--solution", takesValue: false);
    public static readonly Option Quiet = new("--quiet", "-q", takesValue: false);
    public static readonly Option NoProgress = new("--no-progress", takesValue: false);
    public static readonly Option NoBrowser = new("--no-browser", takesValue: false);
    public static readonly Option Version = new("--version", takesValue: false);
    public static readonly Option Help = new("--help", "-h", takesValue: false);

    public readonly string Name, Short;
    public readonly bool TakesValue;

    /// <param name="shortName">With one dash; empty if there is none. Not -c, -f, -r, -a, -p, -v or -e: "dotnet run" uses these itself.</param>
    private Option(string name, string shortName = "", bool takesValue = true)
    {
        (Name, Short, TakesValue) = (name, shortName, takesValue);
        All.Add(this);
    }

    /// <summary>The option with a long or a short name; null if there is none.</summary>
    public static Option? Named(string word) =>
        word == "-?" ? Help : All.Find(option => word == option.Name || word == option.Short);
}
