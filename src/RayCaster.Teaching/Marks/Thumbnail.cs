namespace RayCaster.Teaching;

/// <summary>Small copies of pictures.</summary>
internal static class Thumbnail
{
    /// <summary>The longer side of a copy.</summary>
    private const int Side = 120;

    /// <summary>A smaller copy; a small picture itself.</summary>
    public static Picture Of(Picture picture)
    {
        var longer = Math.Max(picture.Width, picture.Height);
        if (longer <= Side) return picture;
        var small = new SmallPicture(
            picture.Width, picture.Height, Math.Max(1, picture.Width * Side / longer), Math.Max(1, picture.Height * Side / longer));
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
