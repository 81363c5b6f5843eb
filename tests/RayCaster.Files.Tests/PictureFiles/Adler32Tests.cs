namespace RayCaster.Files.Tests.PictureFiles;

public class Adler32Tests
{
    /// <summary>The checksums are Python's, zlib.adler32.</summary>
    [Theory]
    [InlineData(0x00000001u, 0x11E60398u, 9, 0x11E60398u)] // "" + "Wikipedia"
    [InlineData(0x11E60398u, 0x00000001u, 0, 0x11E60398u)]
    [InlineData(0x03DA0195u, 0x06280204u, 5, 0x11E60398u)] // "Wiki" + "pedia"
    [InlineData(0x08000000u, 0x00620062u, 1, 0x08610061u)] // 256 bytes 255 and one 240, behind which a is 0, + "a"
    [InlineData(0xE3E4513Du, 0x53048FBDu, 9_999_999, 0x2103E0F9u)] // 700,000 bytes 255 + 9,999,999 bytes 200
    public void TheChecksumOfTwoPartsIsThatOfTheWhole(uint first, uint rest, long restBytes, uint whole) =>
        Assert.Equal(whole, Adler32.Join(first, rest, restBytes));
}
