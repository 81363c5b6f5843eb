namespace RayCaster.Teaching;

/// <summary>What a picture shows.</summary>
internal static class PictureExtensions
{
    extension(Picture picture)
    {
        /// <summary>Whether all pixels are equal, so that the picture proves nothing.</summary>
        public bool IsOneColor => picture.Rgb.AsSpan(3).SequenceEqual(picture.Rgb.AsSpan(0, picture.Rgb.Length - 3));
    }
}
