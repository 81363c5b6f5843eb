using System.Text.RegularExpressions;

namespace RayCaster.Teaching.Tests.Coverage;

public class SceneVariationTests
{
    private static readonly byte[] scene = Encoding.UTF8.GetBytes(File.ReadAllText(ProjectFolder.PathOf("scenes/weeks/3-boxes.json"))
        .Replace("\"width\": 300, \"height\": 200", "\"width\": 30, \"height\": 20"));

    private static readonly string annas = Vary("anna");

    private static string Vary(string seed) => Encoding.UTF8.GetString(SceneVariation.Create(scene, "", seed, "")!);

    private static Scene Parsed(byte[] utf8) => SceneReader.Parse(utf8, "", "").Scene!;

    [Fact]
    public void OnlyNumbersAreReplaced()
    {
        static string WithoutNumbers(string text) => Regex.Replace(text, @"-?\d+(\.\d+)?", "#");
        Assert.Equal(WithoutNumbers(Encoding.UTF8.GetString(scene)), WithoutNumbers(annas));
    }

    [Fact]
    public void WhatWasEqualStaysEqual()
    {
        var varied = Parsed(Encoding.UTF8.GetBytes(annas));
        var (ground, tower) = (((Model<Aabb>)varied.Models[0]).Primitive, ((Model<Aabb>)varied.Models[1]).Primitive);
        Assert.Equal(ground.Max.Z, tower.Min.Z); // the tower stands on the ground
    }

    [Fact]
    public void TheMistakesThatShowStillDo()
    {
        static HashSet<string> Hidden(byte[] utf8) => [.. MutationCoverage.HiddenIn(Parsed(utf8), null).Hidden.Select(mistake => mistake.Id)];
        Assert.Subset(Hidden(scene), Hidden(Encoding.UTF8.GetBytes(annas)));
    }

    [Fact(Explicit = true)] // its square picture shows "size-mixed" in one variant only, by the last bits of numbers that are equal by symmetry
    public void TheCoursesRoomCanBeVaried() =>
        Assert.NotNull(SceneVariation.Create(File.ReadAllBytes(ProjectFolder.PathOf("scenes/room.json")), "", "anna", ""));

    [Fact(Explicit = true)]
    public void TheSameSeedGivesTheSameSceneAndAnotherAnother()
    {
        Assert.Equal(annas, Vary("anna"));
        Assert.NotEqual(annas, Vary("boris"));
    }

    [Fact(Explicit = true)]
    public void InAnotherFolderTheSchemaIsFound()
    {
        var weeks = ProjectFolder.PathOf("scenes/weeks");
        var moved = Encoding.UTF8.GetString(SceneVariation.Create(scene, weeks, "anna", Path.Combine(weeks, "..", "my", "anna"))!);
        Assert.Contains("\"$schema\": \"../../scene.schema.json\"", moved);
    }
}
