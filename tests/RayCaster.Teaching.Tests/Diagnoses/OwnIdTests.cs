using RayCaster.Teaching.Tests.Mistakes;
using Planted = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>Slips that once had the name of another, whose question misled: planted in the lab's source.</summary>
public class OwnIdTests
{
    [Theory]
    [InlineData("dir-plus-p", "mistakes/portrait", "Camera", "(uc * U + ur * V - W)", "(Position + uc * U + ur * V - W)")]
    [InlineData("rc-swap", "mistakes/generic", "Scene", "Camera.RayThrough(c, r)", "Camera.RayThrough(r, c)")]
    [InlineData("slab-axis", "aabb", "Aabb", "Slab(B0.Y, B1.Y, P.Y, d.Y)", "Slab(B0.Y, B1.Y, P.Y, d.X)")]
    [InlineData("circ-2axes", "mistakes/generic", "Circle", "(X - C).Length <= R", "new Vector3(X.X - C.X, X.Y - C.Y, 0).Length <= R")]
    [InlineData("circ-2axes", "mistakes/generic", "Circle", "(X - C).Length <= R", "new Vector3(X.X - C.X, 0, X.Z - C.Z).Length <= R")]
    public void ASlipHasItsOwnId(string id, string name, string file, string old, string @new)
    {
        var scene = SceneFolder.Small(name, 4);
        var picture = EditedLab.Render(scene, new Planted($"own {@new}", "", new Edit(file, old, @new)));
        var suspect = Diagnosis.Of(scene, picture).Suspects[0];
        Assert.Equal([id], suspect.Mistakes.Select(mistake => mistake.Id));
    }

    [Fact]
    public void APictureWithRowsForColumnsIsTransposed()
    {
        var scene = SceneFolder.Small("mistakes/generic", 4);
        var picture = EditedLab.Render(scene, Planted.Named("transpose"));
        Assert.Equal(["transpose"], Diagnosis.Of(scene, picture).Suspects[0].Mistakes.Select(mistake => mistake.Id));
    }
}
