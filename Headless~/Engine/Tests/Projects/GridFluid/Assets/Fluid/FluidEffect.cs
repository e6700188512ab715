using UnityEngine;

[RequireComponent(typeof(Camera))]
[AddComponentMenu("Image Effects/Fluid")]
public class FluidEffect : MonoBehaviour
{
    enum Pass { Advect, Splat, Divergence, Jacobi, Gradient, Clear, Show }

    [SerializeField] Shader fluidShader;
    [SerializeField, Range(32, 512)] int resolution = 256;
    [SerializeField] int jacobiIterations = 40;
    [SerializeField] float velocityDissipation = 0.2f;
    [SerializeField] float dyeDissipation = 0.1f;
    [SerializeField] float splatRadius = 0.04f;
    [SerializeField] float splatForce = 50;
    [SerializeField] Gradient inks = new Gradient();

    Material mat;
    RenderTexture velocityA, velocityB, dyeA, dyeB;
    Vector2 lastPoint;

    void OnEnable()
    {
        if (fluidShader == null)
            fluidShader = Shader.Find("Hidden/Fluid");
        if (!fluidShader.isSupported)
        {
            enabled = false;
            return;
        }
        mat = new Material(fluidShader) { hideFlags = HideFlags.HideAndDontSave };
        velocityA = CreateRT(RenderTextureFormat.RGHalf);
        velocityB = CreateRT(RenderTextureFormat.RGHalf);
        dyeA = CreateRT(RenderTextureFormat.ARGBHalf);
        dyeB = CreateRT(RenderTextureFormat.ARGBHalf);
        lastPoint = Point(Time.time);
    }

    RenderTexture CreateRT(RenderTextureFormat format)
    {
        var rt = new RenderTexture(resolution, resolution, 0, format, RenderTextureReadWrite.Linear);
        rt.filterMode = FilterMode.Bilinear;
        rt.wrapMode = TextureWrapMode.Clamp;
        rt.Create();
        RenderTexture old = RenderTexture.active;
        RenderTexture.active = rt;
        GL.Clear(false, true, Color.clear);
        RenderTexture.active = old;
        return rt;
    }

    void OnDisable()
    {
        if (mat) DestroyImmediate(mat);
        foreach (var rt in new[] { velocityA, velocityB, dyeA, dyeB })
            if (rt) rt.Release();
    }

    // Stands in for the mouse
    Vector2 Point(float t)
    {
        return new Vector2(0.5f + 0.22f * Mathf.Cos(t * 2.1f), 0.3f + 0.15f * Mathf.Sin(t * 3.3f));
    }

    void Update()
    {
        float dt = Mathf.Min(Time.deltaTime, 1f / 30f);
        mat.SetFloat("_DeltaTime", dt);

        // advect velocity by itself
        mat.SetTexture("_Velocity", velocityA);
        mat.SetFloat("_Dissipation", velocityDissipation);
        Graphics.Blit(velocityA, velocityB, mat, (int)Pass.Advect);
        Swap(ref velocityA, ref velocityB);

        // advect dye
        mat.SetTexture("_Velocity", velocityA);
        mat.SetFloat("_Dissipation", dyeDissipation);
        Graphics.Blit(dyeA, dyeB, mat, (int)Pass.Advect);
        Swap(ref dyeA, ref dyeB);

        // stir and pour
        Vector2 point = Point(Time.time);
        Vector2 force = (point - lastPoint) * splatForce + Vector2.up * 1.5f;
        lastPoint = point;
        mat.SetVector("_Point", point);
        mat.SetFloat("_Radius", splatRadius);
        mat.SetVector("_Splat", force * dt * 8f);
        Graphics.Blit(velocityA, velocityB, mat, (int)Pass.Splat);
        Swap(ref velocityA, ref velocityB);
        mat.SetColor("_Splat", inks.Evaluate(Mathf.Repeat(Time.time * 0.5f, 1f)) * dt * 8f);
        Graphics.Blit(dyeA, dyeB, mat, (int)Pass.Splat);
        Swap(ref dyeA, ref dyeB);

        Project();
    }

    void Project()
    {
        var divergence = RenderTexture.GetTemporary(resolution, resolution, 0, RenderTextureFormat.RHalf, RenderTextureReadWrite.Linear);
        var pressure = RenderTexture.GetTemporary(resolution, resolution, 0, RenderTextureFormat.RHalf, RenderTextureReadWrite.Linear);
        var pressure2 = RenderTexture.GetTemporary(resolution, resolution, 0, RenderTextureFormat.RHalf, RenderTextureReadWrite.Linear);

        Graphics.Blit(velocityA, divergence, mat, (int)Pass.Divergence);
        Graphics.Blit(null, pressure, mat, (int)Pass.Clear);
        mat.SetTexture("_Divergence", divergence);
        for (int i = 0; i < jacobiIterations; i++)
        {
            Graphics.Blit(pressure, pressure2, mat, (int)Pass.Jacobi);
            Swap(ref pressure, ref pressure2);
        }
        mat.SetTexture("_Pressure", pressure);
        Graphics.Blit(velocityA, velocityB, mat, (int)Pass.Gradient);
        Swap(ref velocityA, ref velocityB);

        RenderTexture.ReleaseTemporary(divergence);
        RenderTexture.ReleaseTemporary(pressure);
        RenderTexture.ReleaseTemporary(pressure2);
    }

    static void Swap(ref RenderTexture a, ref RenderTexture b)
    {
        var t = a;
        a = b;
        b = t;
    }

    void OnRenderImage(RenderTexture source, RenderTexture destination)
    {
        mat.SetTexture("_Dye", dyeA);
        Graphics.Blit(source, destination, mat, (int)Pass.Show);
    }
}
