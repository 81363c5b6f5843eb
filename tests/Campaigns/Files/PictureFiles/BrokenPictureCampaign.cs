using static RayCaster.Files.Tests.PictureFiles.BrokenPictureTests;
using static RayCaster.Files.Tests.PictureFiles.TestPng;

namespace RayCaster.Files.Tests.PictureFiles;

/// <summary>A damaged or hostile file is refused with a message: never a crash, never memory for what a header promises.</summary>
public class BrokenPictureCampaign
{
    [Theory]
    [InlineData("grey-1.netpbm.png")]
    [InlineData("palette-2.imagemagick-adam7.png")]
    [InlineData("rgb-8.netpbm-paeth.png")]
    [InlineData("rgb-alpha-16.netpbm-adam7.png")]
    public void AFlippedByteUnderARightChecksumDoesNoHarm(string name)
    {
        foreach (var flip in new byte[] { 0xFF, 0x01, 0x02, 0x20, 0x80 })
        {
            var original = TestData.Bytes(name);
            for (var i = 8; i < original.Length; i++)
            {
                var file = (byte[])original.Clone();
                file[i] ^= flip;
                RefusedOrRead(WithRightChecksums(file));
            }
        }
    }

    [Theory]
    [InlineData("bitmap.imagemagick-p1.pbm")]
    [InlineData("greymap-5.netpbm-p2.pgm")]
    [InlineData("pixmap-1000.netpbm-p3.ppm")]
    [InlineData("bitmap.netpbm-p4.pbm")]
    [InlineData("greymap-1000.netpbm-p5.pgm")]
    [InlineData("pixmap-100.netpbm-p6.ppm")]
    public void AFlippedByteOfAPnmDoesNoHarm(string name)
    {
        var file = TestData.Bytes(name);
        for (var i = 0; i < file.Length; i++)
        {
            foreach (var flip in new byte[] { 0xFF, 0x01, 0x13, 0x20, 0x80 })
            {
                file[i] ^= flip;
                RefusedOrRead(file);
                file[i] ^= flip;
            }
        }
    }
}
