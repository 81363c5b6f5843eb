namespace RayCaster.Teaching;

/// <summary>How one model is shown.</summary>
public enum Look
{
    /// <summary>Like all others.</summary>
    Plain,

    /// <summary>The model is lit, all others are dark.</summary>
    Lit,

    /// <summary>The model also shows where others hide it.</summary>
    Behind,
}

/// <summary>Pictures in which one model stands out.</summary>
public static class ModelPicture
{
    private const int Stripe = 4; // pixels

    /// <summary>Draws the scene with one model lit and the others dark; or with the model visible through those in front of it.</summary>
    /// <param name="model">Its index; −1 for none: all models are dark.</param>
    /// <param name="cancellation">Ends the work between its steps.</param>
    public static Picture Draw(Scene scene, Look look, int model, CancellationToken cancellation)
    {
        var hits = new Renderer(scene).CastHits();
        cancellation.ThrowIfCancellationRequested();
        var picture = new Picture(hits.Width, hits.Height);
        for (var i = 0; i < hits.T.Length; i++)
            picture[i % hits.Width, i / hits.Width] = hits.Model[i] == model ? scene.BytesAt(hits, i) : Dark(scene.BytesAt(hits, i));
        if (look != Look.Behind || model < 0) return picture;

        var alone = scene with { Models = [scene.Models[model]] };
        var own = new Renderer(alone).CastHits();
        cancellation.ThrowIfCancellationRequested();
        for (var i = 0; i < own.T.Length; i++)
        {
            var (x, y) = (i % own.Width, i / own.Width);
            if (own.Model[i] == 0 && hits.Model[i] != model && (x + y) / Stripe % 2 == 0) picture[x, y] = alone.BytesAt(own, i);
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
