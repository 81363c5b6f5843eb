using System.Reflection;
using System.Text.Json;
using System.Text.Json.Serialization;
using System.Text.RegularExpressions;

namespace RayCaster.Live.Tests;

/// <summary>The page's scripts and the program use the same names. No compiler compares the two languages.</summary>
public partial class ProtocolTests
{
    private static readonly Dictionary<string, Type> kinds = typeof(Message).GetCustomAttributes<JsonDerivedTypeAttribute>()
        .ToDictionary(kind => (string)kind.TypeDiscriminator!, kind => kind.DerivedType);

    private static readonly string scripts = string.Concat(((string[])["Page", "Live", "Web"])
        .SelectMany(host => Directory.GetFiles(ProjectFolder.PathOf($"src/RayCaster.{host}/Site"), "*.js")).Select(File.ReadAllText));

    public static TheoryData<string> Kinds => [.. kinds.Keys];

    /// <summary>A variable of a script, and what it holds; the compiler knows no more of it than the reader.</summary>
    public static TheoryData<string, string, Type> Variables => new()
    {
        { "main.js", "scene", typeof(SceneMessage) },
        { "models.js", "scene", typeof(SceneMessage) },
        { "problems.js", "scene", typeof(SceneMessage) },
        { "problems.js", "problem", typeof(ProblemEntry) },
        { "models.js", "model", typeof(ModelEntry) },
        { "models.js", "ledger", typeof(LedgerMessage) },
        { "models.js", "legend", typeof(LegendMessage) },
        { "section.js", "plane", typeof(RayDrawing) },
        { "section.js", "model", typeof(DrawnModel) },
        { "section.js", "crossing", typeof(DrawnCrossing) },
        { "section.js", "end", typeof(DrawnCrossing) },
    };

    [Theory]
    [MemberData(nameof(Kinds))]
    public void WhatAMessageHoldsIsRead(string kind)
    {
        Assert.Contains($"on(\"{kind}\", ", scripts);
        Assert.All(Names(kinds[kind]), name => Assert.Matches($@"(\.|[{{,]\s*){name}\b", scripts));
    }

    [Fact]
    public void WhatAListenerReadsIsInItsMessage()
    {
        var listeners = Listener().Matches(scripts)
            .Where(listener => listener.Groups["kind"].Value is not ("open" or "closed" or "frame")).ToArray();
        Assert.NotEmpty(listeners);
        Assert.All(listeners, listener =>
        {
            var held = Names(kinds[listener.Groups["kind"].Value]);
            var read = listener.Groups["names"].Success ? listener.Groups["names"].Value.Split(',').Select(name => name.Trim())
                : Read(listener.Groups["name"].Value, listener.Groups["body"].Value);
            Assert.All(read, name => Assert.Contains(name, held));
        });
    }

    [Theory]
    [MemberData(nameof(Variables))]
    public void WhatAVariableIsReadForIsInItsMessage(string script, string variable, Type holds)
    {
        var read = Read(variable, File.ReadAllText(ProjectFolder.PathOf($"src/RayCaster.Page/Site/{script}"))).ToArray();
        Assert.NotEmpty(read);
        Assert.All(read, name => Assert.Contains(name, Names(holds)));
    }

    [Fact]
    public void EachRequestIsMadeByAScript()
    {
        var taken = Request().Matches(File.ReadAllText(ProjectFolder.PathOf("src/RayCaster.Page/PageSession.Reading.cs")));
        Assert.NotEmpty(taken);
        Assert.All(taken, request => Assert.Matches($@"[{{,]\s*{request.Groups["name"].Value}\s*[:,}}]", scripts));
    }

    private static IEnumerable<string> Read(string variable, string text) =>
        Regex.Matches(text, $@"(?<![\w.""]){variable}\??\.(?<name>\w+)").Select(use => use.Groups["name"].Value);

    /// <summary>The names in a message's JSON; those of its parts, too.</summary>
    private static string[] Names(Type type) =>
    [
        .. type.GetProperties().Select(property => JsonNamingPolicy.CamelCase.ConvertName(property.Name)),
        .. type.GetProperties().Select(property => property.PropertyType)
            .Select(held => held.IsGenericType ? held.GetGenericArguments()[0] : held)
            .Where(held => held.Namespace!.StartsWith("RayCaster", StringComparison.Ordinal)).SelectMany(Names),
    ];

    [GeneratedRegex("""\bon\("(?<kind>\w+)", (\(\{(?<names>[^}]+)\}\)|\(?(?<name>\w*)\)?) => (?<body>(\{\n.*?\n\}|[^\n]*)\);)""",
        RegexOptions.Singleline)]
    private static partial Regex Listener();

    [GeneratedRegex("case \"(?<name>\\w+)\":")]
    private static partial Regex Request();
}
