using System.Text;
using System.Text.RegularExpressions;

namespace RayCaster.Teaching.Tests.Marks;

public class SceneVariationTests
{
    private static readonly byte[] scene = File.ReadAllBytes(ProjectFolder.PathOf("scenes/weeks/3-boxes.json"));

    private static string Vary(string seed) => Encoding.UTF8.GetString(SceneVariation.Of(scene, "", seed)!);

    [Fact]
    public void TheSameSeedGivesTheSameSceneAndAnotherAnother()
    {
        Assert.Equal(Vary("anna"), Vary("anna"));
        Assert.NotEqual(Vary("anna"), Vary("boris"));
    }

    [Fact]
    public void OnlyNumbersAreReplaced()
    {
        static string WithoutNumbers(string text) => Regex.Replace(text, @"-?\d+(\.\d+)?", "#");
        Assert.Equal(WithoutNumbers(Encoding.UTF8.GetString(scene)), WithoutNumbers(Vary("anna")));
    }

    [Fact]
    public void WhatWasEqualStaysEqualAndTheMistakesThatShowStillDo()
    {
        var varied = SceneReader.Parse(Encoding.UTF8.GetBytes(Vary("clara")), "", "").Scene!;
        var (ground, tower) = (((Model<Aabb>)varied.Models[0]).Primitive, ((Model<Aabb>)varied.Models[1]).Primitive);
        Assert.Equal(ground.Max.Z, tower.Min.Z); // the tower stands on the ground
        var before = SceneFitness.Of([SceneReader.Parse(scene, "", "").Scene!]).Hidden;
        Assert.Subset(before.Select(mistake => mistake.Id).ToHashSet(), SceneFitness.Of([varied]).Hidden.Select(mistake => mistake.Id).ToHashSet());
    }
}
