using System.Text;
using RayCaster.Testing.Fuzzing;

namespace RayCaster.Cli.Tests.Fuzzing;

/// <summary>Command lines of right and wrong words in any order.</summary>
internal static class OddCommandLine
{
    private static readonly CommandList commands = new();

    private static readonly string[] words =
    [
        .. commands.All.SelectMany(command => command.Options).Append(Option.Help).SelectMany(option => option.Names).Distinct(),
        .. commands.All.Select(command => command.Name).Where(name => name != "live"), // it would serve a page until it is interrupted
        .. "- -- --- -? -x --= =x --output= --size=5x5 --size=x --threads=0 -t 1 2 1025 99999999999".Split(' '),
        .. "-1 1e5 -1e400 NaN 5x5 9X7 0x1 1000001x1 1x1x1 a.png a.ppm".Split(' '),
        "", " ", "a b", "..", "\u001b[31m", "\n", "no.json", "ü.png", new('x', 5000),
        "--" + new string('y', 5000), "scene.json", "scene.json", "scene.json",
    ];

    /// <summary>Words separated by NUL, which no command line can contain.</summary>
    public static SeedFile Next(Random random)
    {
        var line = Enumerable.Range(0, random.Next(8)).Select(_ => words[random.Next(words.Length)]);
        return new("line.txt", Encoding.UTF8.GetBytes(string.Join('\0', line)));
    }

    public static string[] Words(SeedFile line) => Encoding.UTF8.GetString(line.Bytes).Split('\0');
}
