using UnityEngine;

[RequireComponent(typeof(MeshRenderer))]
public class Lamp : MonoBehaviour
{
    public Palette palette;
    [Range(0f, 1f)] public float shade = 0.5f;

    static readonly int ColorId = Shader.PropertyToID("_Color");
    MaterialPropertyBlock block;

    void OnEnable()
    {
        Apply();
    }

    public void SetShade(float value)
    {
        shade = value;
        Apply();
    }

    void Apply()
    {
        if (block == null)
            block = new MaterialPropertyBlock();
        var rend = GetComponent<MeshRenderer>();
        rend.GetPropertyBlock(block);
        block.SetColor(ColorId, palette != null ? palette.Evaluate(shade) : Color.magenta);
        rend.SetPropertyBlock(block);
    }
}
