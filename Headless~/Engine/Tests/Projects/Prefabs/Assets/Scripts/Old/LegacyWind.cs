using UnityEngine;

// Not used by any scene any more.
public class LegacyWind : MonoBehaviour
{
    public Cloth cloth;

    void Update()
    {
        Camera.main.RenderToCubemap(new Cubemap(64, TextureFormat.RGBA32, false));
        GetComponent<Renderer>().lightmapIndex = 3;
    }
}
