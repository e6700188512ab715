using System;
using UnityEngine;

namespace Rill
{
    /// <summary>The stages that a component refers to, so that a build with the component contains them.</summary>
    [Serializable]
    sealed class StageReferences
    {
        [SerializeField] StageShader[] stages = Array.Empty<StageShader>();

        [NonSerialized] StageShader[] held;
        FeatureSet followed;

        /// <summary>Stored assets; an element is null where its asset is gone.</summary>
        public StageShader[] Stages => stages;

        /// <summary>Makes the stages findable until <see cref="Release()"/>; twice in a row is safe.</summary>
        public void Hold()
        {
            if (held == stages)
                return;
            StageShader[] before = held;
            held = stages;
            foreach (StageShader stage in held)
                if (stage != null)
                    stage.Hold();
            Release(before);
        }

        public void Release()
        {
            Release(held);
            held = null;
        }

        /// <summary>Follows changed settings: calls <see cref="Update"/> if other features are wanted than at the last call.</summary>
        public void Follow(FeatureSet wanted)
        {
            if (wanted == followed)
                return;
            followed = wanted;
            Update(wanted);
        }

        /// <summary>In the Editor: refers to the stages of these features and no others. In a player it leaves all as it is.</summary>
        /// <returns>Whether anything changed.</returns>
        public bool Update(FeatureSet wanted)
        {
            if (StageShader.EditorFind == null || !TryFindAll(wanted, null, out int count, out bool isSame) || isSame)
                return false;
            var found = new StageShader[count];
            TryFindAll(wanted, found, out _, out _);
            stages = found;
            if (held != null)
                Hold();
            return true;
        }

        // False while an asset has yet to be imported: what is stored then stays.
        bool TryFindAll(FeatureSet wanted, StageShader[] into, out int count, out bool isSame)
        {
            count = 0;
            isSame = true;
            foreach (Feature feature in Features.All)
            {
                if (!wanted.Has(feature))
                    continue;
                foreach (string name in feature.Stages)
                {
                    StageShader stage = StageShader.EditorFind(name);
                    if (stage == null)
                        return false;
                    isSame &= count < stages.Length && ReferenceEquals(stages[count], stage);
                    if (into != null)
                        into[count] = stage;
                    count++;
                }
            }
            isSame &= count == stages.Length;
            return true;
        }

        static void Release(StageShader[] stages)
        {
            if (stages == null)
                return;
            foreach (StageShader stage in stages)
                if (!ReferenceEquals(stage, null))
                    stage.Release();
        }
    }
}
