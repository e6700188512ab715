using System.Collections;
using System.Collections.Generic;
using UnityEngine;

public class Spawner : MonoBehaviour
{
    public string prefabName = "Spark";
    public int amount = 5;
    public float interval = 0.1f;
    [SerializeField] private Transform parent;

    private readonly List<GameObject> sparks = new List<GameObject>();
    private GameObject prefab;

    private IEnumerator Start()
    {
        prefab = Resources.Load<GameObject>("Effects/" + prefabName);
        var palette = Resources.Load("Palettes/Sunset") as Palette;
        Debug.Log("loaded " + prefab.name + " and " + palette.Label);

        for (int i = 0; i < amount; i++)
        {
            var spark = Instantiate(prefab, transform.position + Vector3.right * i * 0.8f, Quaternion.identity, parent);
            spark.name = prefab.name + " " + i;
            spark.GetComponent<Lamp>().SetShade(i / (float)(amount - 1));
            sparks.Add(spark);
            yield return new WaitForSeconds(interval);
        }

        yield return StartCoroutine(Rise(0.5f));
        Debug.Log("risen to " + sparks[0].transform.position.y.ToString("F2"));
        SendMessage("OnAllSpawned", sparks.Count, SendMessageOptions.DontRequireReceiver);
    }

    private IEnumerator Rise(float duration)
    {
        for (float t = 0; t < duration; t += Time.deltaTime)
        {
            foreach (var spark in sparks)
                spark.transform.Translate(Vector3.up * Time.deltaTime * 2f);
            yield return null;
        }
    }

    private void OnAllSpawned(int count)
    {
        Debug.Log(count + " sparks spawned");
        Invoke("Clear", 0.25f);
    }

    private void Clear()
    {
        Destroy(sparks[sparks.Count - 1]);
        sparks.RemoveAt(sparks.Count - 1);
    }
}
