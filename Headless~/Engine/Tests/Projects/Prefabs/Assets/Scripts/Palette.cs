using UnityEngine;

[CreateAssetMenu(fileName = "Palette", menuName = "Towers/Palette", order = 1)]
public class Palette : ScriptableObject
{
    public Gradient gradient;
    public AnimationCurve brightness = AnimationCurve.Linear(0, 0, 1, 1);
    [SerializeField] string label = "unnamed";

    public string Label => label;

    public Color Evaluate(float t)
    {
        return gradient.Evaluate(t) * brightness.Evaluate(t);
    }
}
