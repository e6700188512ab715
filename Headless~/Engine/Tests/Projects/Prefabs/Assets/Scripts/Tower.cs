using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Events;

public class Tower : MonoBehaviour
{
    [Serializable]
    public class Floors
    {
        public int count = 1;
        public float height = 1f;
        public AnimationCurve taper = AnimationCurve.Constant(0, 1, 1);

        [Serializable]
        public struct Window
        {
            public Vector2Int grid;
            public bool lit;
        }

        public List<Window> windows = new List<Window>();
    }

    [SerializeField] Floors floors = new Floors();
    public Lamp[] lamps;
    public UnityEvent onBuilt;
    [Serializable] public class ShadeEvent : UnityEvent<float> { }
    public ShadeEvent onShade = new ShadeEvent();

    public int FloorCount { get { return floors.count; } }

    void Start()
    {
        for (int i = 0; i < floors.count; i++)
        {
            var floor = GameObject.CreatePrimitive(PrimitiveType.Cube);
            floor.name = "Floor " + i;
            floor.transform.SetParent(transform, false);
            float width = floors.taper.Evaluate(floors.count > 1 ? i / (float)(floors.count - 1) : 0);
            floor.transform.localPosition = Vector3.up * (i + 0.5f) * floors.height;
            floor.transform.localScale = new Vector3(width, floors.height * 0.95f, width);
            floor.GetComponent<Renderer>().sharedMaterial = lamps[0].GetComponent<Renderer>().sharedMaterial;
        }
        int lit = floors.windows.FindAll(w => w.lit).Count;
        Debug.LogFormat("{0}: {1} floors, {2} of {3} windows lit, {4} lamps", name, floors.count, lit, floors.windows.Count, lamps.Length);
        onBuilt.Invoke();
        onShade.Invoke(0.25f);
    }

    public void Announce(string message)
    {
        Debug.Log(name + " says " + message);
    }
}
