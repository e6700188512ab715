namespace UnityEngine
{
    public sealed class MeshRenderer : Renderer
    {
        internal override Mesh MeshToDraw => TryGetComponent(out MeshFilter filter) ? filter.sharedMesh : null;
        public int subMeshStartIndex => 0;
        public Mesh additionalVertexStreams { get; set; }
    }

    public sealed class MeshFilter : Component
    {
        bool own;
        Mesh current;

        internal override void OnCopied(Component source) => current = ((MeshFilter)source).current;

        public Mesh sharedMesh
        {
            get => current;
            set
            {
                current = value;
                own = false;
            }
        }

        /// <summary>A copy of its own, made at the first access.</summary>
        public Mesh mesh
        {
            get
            {
                if (!own && current != null)
                {
                    string original = current.name;
                    current = (Mesh)current.CloneNative();
                    current.name = original + " Instance";
                    own = true;
                }
                else if (current == null)
                {
                    current = new Mesh();
                    own = true;
                }
                return current;
            }
            set => sharedMesh = value;
        }
    }
}
