namespace RayCaster.Live;

/// <summary>How one model is shown: like all others; lit, and all others dark; or lit also where others hide it.</summary>
internal enum Look { Plain, Lit, Behind }

internal static class ModelPicture
{
    private const int Stripe = 4; // pixels

    /// <summary>Draws the scene with one model lit and the others dark; or with the model visible through those in front of it.</summary>
    /// <param name="model">Its index; −1 for none: all models are dark.</param>
    public static Picture Draw(Scene scene, Look look, int model, CancellationToken cancellation)
    {
        var hits = new Renderer(scene).CastHits();
        cancellation.ThrowIfCancellationRequested();
        var picture = new Picture(hits.Width, hits.Height);
        for (var i = 0; i < hits.T.Length; i++)
        {
            var shown = scene.Shade(hits.T[i], hits.Model[i] < 0 ? null : scene.Models[hits.Model[i]]).ToBytes();
            picture[i % hits.Width, i / hits.Width] = hits.Model[i] == model ? shown : Dark(shown);
        }
        if (look != Look.Behind || model < 0) return picture;

        var alone = new Renderer(scene with { Models = [scene.Models[model]] }).CastHits();
        cancellation.ThrowIfCancellationRequested();
        for (var i = 0; i < alone.T.Length; i++)
        {
            var (y, x) = Math.DivRem(i, alone.Width);
            if (alone.Model[i] == 0 && hits.Model[i] != model && (x + y) / Stripe % 2 == 0)
                picture[x, y] = scene.Shade(alone.T[i], scene.Models[model]).ToBytes();
        }
        return picture;
    }

    /// <summary>A quarter of the light, in grey: the shapes are still visible.</summary>
    private static (byte, byte, byte) Dark((byte R, byte G, byte B) color)
    {
        var grey = (byte)((color.R + 2 * color.G + color.B) / 16);
        return (grey, grey, grey);
    }
}
