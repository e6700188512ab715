using UnityEngine;

namespace Rill.Samples
{
    /// <summary>Shows the level of the water by a pointer that follows a probe, and what is left to pour by a column.</summary>
    public sealed class WellGauges : MonoBehaviour
    {
        [Tooltip("The game whose water is shown.")]
        [SerializeField] WellGame game;

        [Tooltip("In the well; tells the height of the surface.")]
        [SerializeField] FluidProbe probe;

        [Tooltip("Moves up and down with the surface.")]
        [SerializeField] Transform pointer;

        [Tooltip("As high as the water that is left: its scale along y is 1 at the start.")]
        [SerializeField] Transform column;

        [Tooltip("How fast the pointer follows, 1/s.")]
        [Range(0.5f, 60f)]
        [SerializeField] float speed = 6f;

        void Update()
        {
            column.localScale = new Vector3(1f, Mathf.Max(game.WaterLeft, 0.001f), 1f);
            if (!probe.TryGetSample(out FluidProbeSample water) || !water.hasSurface)
                return;
            Vector3 at = pointer.position;
            at.y = Mathf.Lerp(at.y, water.ExtrapolatedHeight, 1f - Mathf.Exp(-speed * Time.deltaTime));
            pointer.position = at;
        }
    }
}
