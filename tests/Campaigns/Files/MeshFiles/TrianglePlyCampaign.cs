using static RayCaster.Files.Tests.MeshFiles.TrianglePlyTests;

namespace RayCaster.Files.Tests.MeshFiles;

/// <summary>The fast reader of triangle PLYs gives the same result as the general one, or leaves the file to it.</summary>
public class TrianglePlyCampaign
{
    [Fact]
    public void WithAnyByteChangedItIsTheLongWaysAnswerOrNone()
    {
        var (random, right, read) = (new Random(1), MeshWriter.PlyFloat(mesh), 0);
        for (var round = 0; round < 20_000; round++)
        {
            var bytes = right.ToArray();
            for (var change = random.Next(2); change >= 0; change--) bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
            MeshData? quick;
            try
            {
                quick = Short(bytes);
            }
            catch (MeshFileException)
            {
                continue; // the header
            }
            if (quick is null) continue;
            read++;
            var thorough = Long(bytes);
            Assert.Equal(Bits(thorough.Vertices), Bits(quick.Vertices));
            Assert.Equal(thorough.Indices, quick.Indices);
        }
        Assert.InRange(read, 2000, 19_000);
    }
}
