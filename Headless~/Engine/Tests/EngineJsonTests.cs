using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Host.Tests
{
    public class EngineJsonTests
    {
        enum Kind { None, Some = 7 }

        [Serializable]
        class Inner
        {
            public string name;
            [SerializeField] float secret = 0.5f;
            public float Secret => secret;
        }

        [Serializable]
        class Data
        {
            public int number = 3;
            public float tenth = 0.1f;
            public bool flag = true;
            public Kind kind = Kind.Some;
            public Vector2 position = new Vector2(1, -2.5f);
            public int[] list = { 1, 2 };
            public List<Inner> inners = new List<Inner> { new Inner { name = "a \"b\"" } };
            [NonSerialized] public int hidden = 9;
            int alsoHidden = 9;
            public int Sum => hidden + alsoHidden;
        }

        [Test]
        public void Fields_that_Unity_serializes_are_written_as_Unity_writes_them() => Assert.That(JsonUtility.ToJson(new Data()), Is.EqualTo(
            "{\"number\":3,\"tenth\":0.10000000149011612,\"flag\":true,\"kind\":7,\"position\":{\"x\":1.0,\"y\":-2.5},\"list\":[1,2],\"inners\":[{\"name\":\"a \\\"b\\\"\",\"secret\":0.5}]}"));

        [Test]
        public void Pretty_print_breaks_lines_and_indents_by_four()
            => Assert.That(JsonUtility.ToJson(new Inner(), true), Is.EqualTo("{\n    \"name\": \"\",\n    \"secret\": 0.5\n}"));

        [Test]
        public void What_was_written_is_read_again()
        {
            var data = new Data { number = -4, position = new Vector2(8, 9), list = new[] { 5 }, hidden = 1 };
            data.inners[0].name = "tab\tand é \u2192";
            var read = JsonUtility.FromJson<Data>(JsonUtility.ToJson(data, true));
            Assert.That(JsonUtility.ToJson(read), Is.EqualTo(JsonUtility.ToJson(data)));
            Assert.That(read.hidden, Is.EqualTo(9));
        }

        [Test]
        public void A_key_that_is_missing_or_unknown_changes_nothing()
        {
            var data = new Data();
            JsonUtility.FromJsonOverwrite(
                " { \"position\" : { \"y\" : 4 }, \"stranger\" : [ { } , null ], \"kind\" : 0, \"list\" : \"no list\" } ", data);
            Assert.That(data.position, Is.EqualTo(new Vector2(1, 4)));
            Assert.That(data.kind, Is.EqualTo(Kind.None));
            Assert.That(data.list, Is.EqualTo(new[] { 1, 2 }));
            Assert.That(data.number, Is.EqualTo(3));
        }

        [TestCase("{\"number\":}")]
        [TestCase("{\"number\":1")]
        [TestCase("{\"name\":\"open}")]
        [TestCase("[1]")]
        [TestCase("{} {}")]
        public void Bad_json_is_refused(string json)
            => Assert.That(Assert.Throws<ArgumentException>(() => JsonUtility.FromJson<Data>(json)).Message, Does.Contain("JSON"));

        [Test]
        public void Preferences_hold_values_by_type()
        {
            PlayerPrefs.DeleteAll();
            PlayerPrefs.SetInt("a", 4);
            PlayerPrefs.SetString("b", "text");
            Assert.That(PlayerPrefs.GetInt("a"), Is.EqualTo(4));
            Assert.That(PlayerPrefs.GetString("b", "other"), Is.EqualTo("text"));
            Assert.That(PlayerPrefs.GetFloat("a", 0.5f), Is.EqualTo(0.5f), "of another type");
            Assert.That(PlayerPrefs.HasKey("c"), Is.False);
            PlayerPrefs.DeleteKey("a");
            Assert.That(PlayerPrefs.HasKey("a"), Is.False);
            PlayerPrefs.DeleteAll();
        }
    }
}
