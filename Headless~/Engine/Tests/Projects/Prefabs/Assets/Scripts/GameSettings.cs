using UnityEngine;

public class GameSettings : MonoBehaviour
{
    public static GameSettings Current { get; private set; }

    [System.Serializable]
    class SaveData
    {
        public int runs;
        public string player = "none";
        public Vector3 position;
    }

    public int targetFrameRate = 60;

    [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.BeforeSceneLoad)]
    static void Boot()
    {
        Debug.Log("booting " + Application.productName);
    }

    void Awake()
    {
        Current = this;
        Application.targetFrameRate = targetFrameRate;
        DontDestroyOnLoad(gameObject);

        var save = JsonUtility.FromJson<SaveData>(PlayerPrefs.GetString("save", "{\"runs\":2,\"position\":{\"x\":1.5}}"));
        save.runs++;
        PlayerPrefs.SetString("save", JsonUtility.ToJson(save));
        Debug.Log("saved " + PlayerPrefs.GetString("save"));
    }

    void Update()
    {
        if (Input.GetButtonDown("Jump"))
            FindObjectOfType<Spawner>().enabled = false;
    }
}
