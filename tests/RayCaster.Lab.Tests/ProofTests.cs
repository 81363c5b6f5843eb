using RayCaster.Files;
using RayCaster.Teaching;

namespace Lab.Tests;

/// <summary>What a failed picture test calls wrong is never right code.</summary>
public class ProofTests
{
    /// <summary>A hit where none is right is not within any tolerance.</summary>
    [Fact]
    public void NoHitIsNotEqualToAHit()
    {
        Assert.False(RayAssert.AreEqual(double.PositiveInfinity, 5));
        Assert.False(RayAssert.AreEqual(5, double.PositiveInfinity));
        Assert.True(RayAssert.AreEqual(double.PositiveInfinity, double.PositiveInfinity));
    }

    [Theory]
    [MemberData(nameof(DefinitionTests.Scenes), MemberType = typeof(DefinitionTests))]
    public void NothingOfTheSolvedLabIsCalledWrong(string name)
    {
        var scene = SceneReader.Read(Path.Combine(ProjectFolder.PathOf("scenes"), name)).Scene;
        if (scene.Models.Any(model => model is RayCaster.Mesh)) return; // no step draws one, and each ray meets thousands of triangles
        foreach (var step in Enumerable.Range(LabSteps.FirstPicture, LabSteps.Count - LabSteps.FirstPicture + 1))
        {
            var proof = new Proof(LabSteps.SceneAt(scene, step));
            Assert.All(Slides.Steps.SelectMany(of => of.Slides), slide => Assert.True(proof.IsRight(slide) != false, $"step {step}, slide {slide}"));
        }
    }
}
