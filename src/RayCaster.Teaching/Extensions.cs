namespace RayCaster.Teaching;

/// <summary>What scenes and pictures show.</summary>
internal static class Extensions
{
    extension(Scene scene)
    {
        /// <summary>How many shapes there are; each triangle of a mesh counts.</summary>
        public long ShapeCount => scene.Models.Sum(model => model is Mesh mesh ? mesh.TriangleCount : 1L);
    }

    extension(Picture picture)
    {
        /// <summary>Whether all pixels are equal, so that the picture proves nothing.</summary>
        public bool IsOneColor => picture.Rgb.AsSpan(3).SequenceEqual(picture.Rgb.AsSpan(0, picture.Rgb.Length - 3));
    }
}
