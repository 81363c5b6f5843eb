namespace RayCaster.Teaching;

/// <summary>Small copies of pictures.</summary>
internal static class Thumbnail
{
    /// <summary>The longer side of a copy for people, and of a copy for comparing.</summary>
    public const int Seen = 120, Tiny = 16;

    /// <summary>A copy whose longer side has so many pixels; a smaller picture itself.</summary>
    public static Picture Of(Picture picture, int side)
    {
        var longer = Math.Max(picture.Width, picture.Height);
        if (longer <= side) return picture;
        var small = new SmallPicture(
            picture.Width, picture.Height, Math.Max(1, picture.Width * side / longer), Math.Max(1, picture.Height * side / longer));
        small.Take(picture.Rgb);
        return small.Picture;
    }

    public static byte[] ToPng(this Picture picture)
    {
        using var bytes = new MemoryStream();
        PictureFile.Write(bytes, picture, PictureFormat.Png);
        return bytes.ToArray();
    }
}
