using RayCaster.Teaching.Tests.Mistakes;

namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>Pictures of scenes with a wrong number in them: no mistake of the program makes these, and none may be accused.</summary>
public class LikelyCauseTests
{
    internal static readonly Scene room = SceneFolder.Small("room", 5), generic = SceneFolder.Small("mistakes/generic", 4);

    [Fact]
    public void ALightThatClampsChannelsIsALight()
    {
        var bubble = SceneFolder.Small("mistakes/bubble", 2);
        var (right, bright) = (ScalarRenderer.Render(bubble), ScalarRenderer.Render(bubble));
        for (var i = 0; i < bright.Rgb.Length; i++) bright.Rgb[i] = (byte)Math.Min(255, 1.5 * bright.Rgb[i]);
        var models = new Renderer(bubble).CastHits().Model;
        Assert.Contains("sphere", LikelyCause.InAnotherLight(new(bubble, right, bright, 3000, true), models).Keys);
    }

    internal static Diagnosis Of(Scene scene, Scene drawn) => Diagnosis.Of(scene, EditedLab.Render(drawn, Mistakes.Mistake.None));

    internal static Scene Seen(Scene scene, Vector3? target = null, double? zFar = null, double? fovY = null)
    {
        var c = scene.Camera;
        return scene with
        {
            Camera = c.With(target: target ?? c.Target, fovY: fovY ?? c.FovY, zFar: zFar ?? c.ZFar),
        };
    }
}
