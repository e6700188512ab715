// com.unity.ugui's API shape for projects that have it: elements hold their values and raise their events when a script
// sets them; no one clicks and nothing is drawn.
using System;
using System.Collections.Generic;
using UnityEngine.Events;
using UnityEngine.EventSystems;

namespace UnityEngine.EventSystems
{
    public abstract class UIBehaviour : MonoBehaviour
    {
        protected virtual void Awake() { }
        protected virtual void OnEnable() { }
        protected virtual void Start() { }
        protected virtual void OnDisable() { }
        protected virtual void OnDestroy() { }
        protected virtual void OnRectTransformDimensionsChange() { }
        protected virtual void OnBeforeTransformParentChanged() { }
        protected virtual void OnTransformParentChanged() { }
        protected virtual void OnDidApplyAnimationProperties() { }
        protected virtual void OnCanvasGroupChanged() { }
        protected virtual void OnCanvasHierarchyChanged() { }
        public virtual bool IsActive() => isActiveAndEnabled;
        public bool IsDestroyed() => this == null;
    }

    public abstract class AbstractEventData
    {
        protected bool m_Used;
        public virtual bool used => m_Used;
        public virtual void Reset() => m_Used = false;
        public virtual void Use() => m_Used = true;
    }

    public class BaseEventData : AbstractEventData
    {
        public BaseEventData(EventSystem eventSystem) { }
        public GameObject selectedObject { get; set; }
    }

    public class AxisEventData : BaseEventData
    {
        public AxisEventData(EventSystem eventSystem) : base(eventSystem) { }
        public Vector2 moveVector { get; set; }
        public MoveDirection moveDir { get; set; }
    }

    public enum MoveDirection { Left, Up, Right, Down, None }

    public struct RaycastResult
    {
        public GameObject gameObject { get; set; }
        public float distance;
        public float index;
        public int depth;
        public int sortingLayer;
        public int sortingOrder;
        public Vector3 worldPosition;
        public Vector3 worldNormal;
        public Vector2 screenPosition;
        public int displayIndex;
        public bool isValid => gameObject != null;
        public void Clear() => this = default;
    }

    public class PointerEventData : BaseEventData
    {
        public enum InputButton { Left = 0, Right = 1, Middle = 2 }
        public enum FramePressState { Pressed, Released, PressedAndReleased, NotChanged }

        public PointerEventData(EventSystem eventSystem) : base(eventSystem) { }
        public List<GameObject> hovered = new List<GameObject>();
        public GameObject pointerEnter { get; set; }
        public GameObject lastPress { get; }
        public GameObject pointerPress { get; set; }
        public GameObject rawPointerPress { get; set; }
        public GameObject pointerDrag { get; set; }
        public GameObject pointerClick { get; set; }
        public RaycastResult pointerCurrentRaycast { get; set; }
        public RaycastResult pointerPressRaycast { get; set; }
        public bool eligibleForClick { get; set; }
        public int pointerId { get; set; }
        public Vector2 position { get; set; }
        public Vector2 delta { get; set; }
        public Vector2 pressPosition { get; set; }
        public float clickTime { get; set; }
        public int clickCount { get; set; }
        public Vector2 scrollDelta { get; set; }
        public bool useDragThreshold { get; set; }
        public bool dragging { get; set; }
        public InputButton button { get; set; }
        public bool IsPointerMoving() => delta.sqrMagnitude > 0;
        public bool IsScrolling() => scrollDelta.sqrMagnitude > 0;
    }

    public interface IEventSystemHandler { }
    public interface IPointerMoveHandler : IEventSystemHandler { void OnPointerMove(PointerEventData eventData); }
    public interface IPointerEnterHandler : IEventSystemHandler { void OnPointerEnter(PointerEventData eventData); }
    public interface IPointerExitHandler : IEventSystemHandler { void OnPointerExit(PointerEventData eventData); }
    public interface IPointerDownHandler : IEventSystemHandler { void OnPointerDown(PointerEventData eventData); }
    public interface IPointerUpHandler : IEventSystemHandler { void OnPointerUp(PointerEventData eventData); }
    public interface IPointerClickHandler : IEventSystemHandler { void OnPointerClick(PointerEventData eventData); }
    public interface IBeginDragHandler : IEventSystemHandler { void OnBeginDrag(PointerEventData eventData); }
    public interface IInitializePotentialDragHandler : IEventSystemHandler { void OnInitializePotentialDrag(PointerEventData eventData); }
    public interface IDragHandler : IEventSystemHandler { void OnDrag(PointerEventData eventData); }
    public interface IEndDragHandler : IEventSystemHandler { void OnEndDrag(PointerEventData eventData); }
    public interface IDropHandler : IEventSystemHandler { void OnDrop(PointerEventData eventData); }
    public interface IScrollHandler : IEventSystemHandler { void OnScroll(PointerEventData eventData); }
    public interface IUpdateSelectedHandler : IEventSystemHandler { void OnUpdateSelected(BaseEventData eventData); }
    public interface ISelectHandler : IEventSystemHandler { void OnSelect(BaseEventData eventData); }
    public interface IDeselectHandler : IEventSystemHandler { void OnDeselect(BaseEventData eventData); }
    public interface IMoveHandler : IEventSystemHandler { void OnMove(AxisEventData eventData); }
    public interface ISubmitHandler : IEventSystemHandler { void OnSubmit(BaseEventData eventData); }
    public interface ICancelHandler : IEventSystemHandler { void OnCancel(BaseEventData eventData); }

    public class EventSystem : UIBehaviour
    {
        [SerializeField] GameObject m_FirstSelected;
        [SerializeField] bool m_sendNavigationEvents = true;
        [SerializeField] int m_DragThreshold = 10;

        public static EventSystem current { get; set; }
        protected override void OnEnable() { if (current == null) current = this; }
        protected override void OnDisable() { if (current == this) current = null; }
        public bool sendNavigationEvents { get => m_sendNavigationEvents; set => m_sendNavigationEvents = value; }
        public int pixelDragThreshold { get => m_DragThreshold; set => m_DragThreshold = value; }
        public BaseInputModule currentInputModule => null;
        public GameObject firstSelectedGameObject { get => m_FirstSelected; set => m_FirstSelected = value; }
        public GameObject currentSelectedGameObject { get; private set; }
        public bool isFocused => true;
        public bool alreadySelecting => false;
        public void SetSelectedGameObject(GameObject selected) => currentSelectedGameObject = selected;
        public void SetSelectedGameObject(GameObject selected, BaseEventData pointer) => currentSelectedGameObject = selected;
        public bool IsPointerOverGameObject() => false;
        public bool IsPointerOverGameObject(int pointerId) => false;
        public void RaycastAll(PointerEventData eventData, List<RaycastResult> raycastResults) => raycastResults.Clear();
        public void UpdateModules() { }
    }

    public abstract class BaseInputModule : UIBehaviour { }
    public abstract class PointerInputModule : BaseInputModule { }
    public class StandaloneInputModule : PointerInputModule { }
    public abstract class BaseRaycaster : UIBehaviour { }
    public class PhysicsRaycaster : BaseRaycaster { }
    public class Physics2DRaycaster : PhysicsRaycaster { }

    public enum EventTriggerType
    {
        PointerEnter = 0, PointerExit = 1, PointerDown = 2, PointerUp = 3, PointerClick = 4, Drag = 5, Drop = 6, Scroll = 7, UpdateSelected = 8,
        Select = 9, Deselect = 10, Move = 11, InitializePotentialDrag = 12, BeginDrag = 13, EndDrag = 14, Submit = 15, Cancel = 16,
    }

    public class EventTrigger : MonoBehaviour
    {
        [Serializable] public class TriggerEvent : UnityEvent<BaseEventData> { }
        [Serializable] public class Entry
        {
            public EventTriggerType eventID = EventTriggerType.PointerClick;
            public TriggerEvent callback = new TriggerEvent();
        }
        public List<Entry> triggers { get; set; } = new List<Entry>();
    }
}

namespace UnityEngine.UI
{
    public interface ICanvasElement { Transform transform { get; } void Rebuild(CanvasUpdate executing); }
    public enum CanvasUpdate { Prelayout = 0, Layout = 1, PostLayout = 2, PreRender = 3, LatePreRender = 4 }
    public interface IMaterialModifier { Material GetModifiedMaterial(Material baseMaterial); }
    public interface ILayoutElement { }

    public abstract class Graphic : UIBehaviour
    {
        [SerializeField] Material m_Material;
        [SerializeField] Color m_Color = Color.white;
        [SerializeField] bool m_RaycastTarget = true;

        public virtual Color color { get => m_Color; set => m_Color = value; }
        public virtual bool raycastTarget { get => m_RaycastTarget; set => m_RaycastTarget = value; }
        public virtual Material material { get => m_Material; set => m_Material = value; }
        public virtual Material defaultMaterial => null;
        public virtual Material materialForRendering => material;
        public virtual Texture mainTexture => Texture2D.whiteTexture;
        public RectTransform rectTransform => transform as RectTransform;
        public Canvas canvas => GetComponentInParent<Canvas>();
        public int depth => -1;
        public virtual void SetAllDirty() { }
        public virtual void SetLayoutDirty() { }
        public virtual void SetVerticesDirty() { }
        public virtual void SetMaterialDirty() { }
        public virtual void SetNativeSize() { }
        public virtual void CrossFadeColor(Color targetColor, float duration, bool ignoreTimeScale, bool useAlpha) { }
        public virtual void CrossFadeAlpha(float alpha, float duration, bool ignoreTimeScale) { }
    }

    public abstract class MaskableGraphic : Graphic
    {
        [SerializeField] bool m_Maskable = true;
        public bool maskable { get => m_Maskable; set => m_Maskable = value; }
    }

    [Serializable]
    public class FontData
    {
        [SerializeField] Font m_Font;
        [SerializeField] int m_FontSize = 14;
        [SerializeField] FontStyle m_FontStyle;
        [SerializeField] bool m_BestFit;
        [SerializeField] int m_MinSize = 10;
        [SerializeField] int m_MaxSize = 40;
        [SerializeField] TextAnchor m_Alignment;
        [SerializeField] bool m_RichText = true;
        [SerializeField] float m_LineSpacing = 1;

        public Font font { get => m_Font; set => m_Font = value; }
        public int fontSize { get => m_FontSize; set => m_FontSize = value; }
        public FontStyle fontStyle { get => m_FontStyle; set => m_FontStyle = value; }
        public bool bestFit { get => m_BestFit; set => m_BestFit = value; }
        public int minSize { get => m_MinSize; set => m_MinSize = value; }
        public int maxSize { get => m_MaxSize; set => m_MaxSize = value; }
        public TextAnchor alignment { get => m_Alignment; set => m_Alignment = value; }
        public bool richText { get => m_RichText; set => m_RichText = value; }
        public float lineSpacing { get => m_LineSpacing; set => m_LineSpacing = value; }
    }

    public class Text : MaskableGraphic
    {
        [SerializeField] FontData m_FontData = new FontData();
        [SerializeField] string m_Text = "";

        public virtual string text { get => m_Text; set => m_Text = value ?? ""; }
        public Font font { get => m_FontData.font; set => m_FontData.font = value; }
        public int fontSize { get => m_FontData.fontSize; set => m_FontData.fontSize = value; }
        public FontStyle fontStyle { get => m_FontData.fontStyle; set => m_FontData.fontStyle = value; }
        public TextAnchor alignment { get => m_FontData.alignment; set => m_FontData.alignment = value; }
        public bool supportRichText { get => m_FontData.richText; set => m_FontData.richText = value; }
        public bool resizeTextForBestFit { get => m_FontData.bestFit; set => m_FontData.bestFit = value; }
        public int resizeTextMinSize { get => m_FontData.minSize; set => m_FontData.minSize = value; }
        public int resizeTextMaxSize { get => m_FontData.maxSize; set => m_FontData.maxSize = value; }
        public float lineSpacing { get => m_FontData.lineSpacing; set => m_FontData.lineSpacing = value; }
        public virtual float preferredWidth => 0;
        public virtual float preferredHeight => 0;
    }

    public class Image : MaskableGraphic
    {
        public enum Type { Simple, Sliced, Tiled, Filled }
        public enum FillMethod { Horizontal, Vertical, Radial90, Radial180, Radial360 }

        [SerializeField] Sprite m_Sprite;
        [SerializeField] Type m_Type;
        [SerializeField] bool m_PreserveAspect;
        [SerializeField] float m_FillAmount = 1;

        public Sprite sprite { get => m_Sprite; set => m_Sprite = value; }
        public Sprite overrideSprite { get; set; }
        public Type type { get => m_Type; set => m_Type = value; }
        public FillMethod fillMethod { get; set; } = FillMethod.Radial360;
        public float fillAmount { get => m_FillAmount; set => m_FillAmount = Mathf.Clamp01(value); }
        public bool fillCenter { get; set; } = true;
        public bool fillClockwise { get; set; } = true;
        public int fillOrigin { get; set; }
        public bool preserveAspect { get => m_PreserveAspect; set => m_PreserveAspect = value; }
        public float alphaHitTestMinimumThreshold { get; set; }
    }

    public class RawImage : MaskableGraphic
    {
        [SerializeField] Texture m_Texture;
        [SerializeField] Rect m_UVRect = new Rect(0, 0, 1, 1);

        public Texture texture { get => m_Texture; set => m_Texture = value; }
        public Rect uvRect { get => m_UVRect; set => m_UVRect = value; }
        public override Texture mainTexture => m_Texture;
    }

    [Serializable]
    public struct ColorBlock
    {
        public Color normalColor { get; set; }
        public Color highlightedColor { get; set; }
        public Color pressedColor { get; set; }
        public Color selectedColor { get; set; }
        public Color disabledColor { get; set; }
        public float colorMultiplier { get; set; }
        public float fadeDuration { get; set; }
    }

    public class Selectable : UIBehaviour
    {
        public enum Transition { None, ColorTint, SpriteSwap, Animation }

        [SerializeField] bool m_Interactable = true;
        [SerializeField] Graphic m_TargetGraphic;

        public bool interactable { get => m_Interactable; set => m_Interactable = value; }
        public Graphic targetGraphic { get => m_TargetGraphic; set => m_TargetGraphic = value; }
        public Transition transition { get; set; } = Transition.ColorTint;
        public ColorBlock colors { get; set; }
        public Image image { get => m_TargetGraphic as Image; set => m_TargetGraphic = value; }
        public virtual bool IsInteractable() => m_Interactable;
        public virtual void Select() { }
    }

    public class Button : Selectable
    {
        [Serializable] public class ButtonClickedEvent : UnityEvent { }
        [SerializeField] ButtonClickedEvent m_OnClick = new ButtonClickedEvent();
        public ButtonClickedEvent onClick { get => m_OnClick; set => m_OnClick = value; }
    }

    public class Toggle : Selectable
    {
        [Serializable] public class ToggleEvent : UnityEvent<bool> { }
        public ToggleEvent onValueChanged = new ToggleEvent();
        public Graphic graphic;
        [SerializeField] bool m_IsOn;

        public ToggleGroup group { get; set; }
        public bool isOn
        {
            get => m_IsOn;
            set
            {
                if (m_IsOn == value) return;
                m_IsOn = value;
                onValueChanged.Invoke(value);
            }
        }
        public void SetIsOnWithoutNotify(bool value) => m_IsOn = value;
    }

    public class ToggleGroup : UIBehaviour { public bool allowSwitchOff { get; set; } }

    public class Slider : Selectable
    {
        public enum Direction { LeftToRight, RightToLeft, BottomToTop, TopToBottom }
        [Serializable] public class SliderEvent : UnityEvent<float> { }

        [SerializeField] float m_MinValue;
        [SerializeField] float m_MaxValue = 1;
        [SerializeField] bool m_WholeNumbers;
        [SerializeField] protected float m_Value;
        [SerializeField] SliderEvent m_OnValueChanged = new SliderEvent();

        public float minValue { get => m_MinValue; set { m_MinValue = value; Set(m_Value, true); } }
        public float maxValue { get => m_MaxValue; set { m_MaxValue = value; Set(m_Value, true); } }
        public bool wholeNumbers { get => m_WholeNumbers; set { m_WholeNumbers = value; Set(m_Value, true); } }
        public virtual float value { get => m_WholeNumbers ? Mathf.Round(m_Value) : m_Value; set => Set(value, true); }
        public float normalizedValue { get => Mathf.InverseLerp(m_MinValue, m_MaxValue, value);
            set => this.value = Mathf.Lerp(m_MinValue, m_MaxValue, value); }
        public Direction direction { get; set; }
        public SliderEvent onValueChanged { get => m_OnValueChanged; set => m_OnValueChanged = value; }
        public virtual void SetValueWithoutNotify(float input) => Set(input, false);

        protected virtual void Set(float input, bool sendCallback)
        {
            input = Mathf.Clamp(input, m_MinValue, m_MaxValue);
            if (m_WholeNumbers) input = Mathf.Round(input);
            if (m_Value == input) return;
            m_Value = input;
            if (sendCallback) m_OnValueChanged.Invoke(input);
        }
    }

    public class Scrollbar : Selectable
    {
        [Serializable] public class ScrollEvent : UnityEvent<float> { }
        public float value { get; set; }
        public float size { get; set; } = 0.2f;
        public int numberOfSteps { get; set; }
        public ScrollEvent onValueChanged { get; set; } = new ScrollEvent();
    }

    public class ScrollRect : UIBehaviour
    {
        [Serializable] public class ScrollRectEvent : UnityEvent<Vector2> { }
        public RectTransform content { get; set; }
        public bool horizontal { get; set; } = true;
        public bool vertical { get; set; } = true;
        public Vector2 normalizedPosition { get; set; }
        public float horizontalNormalizedPosition { get; set; }
        public float verticalNormalizedPosition { get; set; }
        public ScrollRectEvent onValueChanged { get; set; } = new ScrollRectEvent();
    }

    public class InputField : Selectable
    {
        [Serializable] public class SubmitEvent : UnityEvent<string> { }
        [Serializable] public class EndEditEvent : UnityEvent<string> { }
        [Serializable] public class OnChangeEvent : UnityEvent<string> { }

        [SerializeField] string m_Text = "";

        public string text { get => m_Text; set { m_Text = value ?? ""; onValueChanged.Invoke(m_Text); } }
        public bool isFocused => false;
        public Text textComponent { get; set; }
        public Graphic placeholder { get; set; }
        public int characterLimit { get; set; }
        public EndEditEvent onEndEdit { get; set; } = new EndEditEvent();
        public SubmitEvent onSubmit { get; set; } = new SubmitEvent();
        public OnChangeEvent onValueChanged { get; set; } = new OnChangeEvent();
        public void SetTextWithoutNotify(string input) => m_Text = input ?? "";
        public void ActivateInputField() { }
        public void DeactivateInputField() { }
    }

    public class Dropdown : Selectable
    {
        [Serializable] public class OptionData
        {
            public OptionData() { }
            public OptionData(string text) { this.text = text; }
            public OptionData(string text, Sprite image) { this.text = text; this.image = image; }
            [SerializeField] string m_Text;
            [SerializeField] Sprite m_Image;
            public string text { get => m_Text; set => m_Text = value; }
            public Sprite image { get => m_Image; set => m_Image = value; }
        }
        [Serializable] public class DropdownEvent : UnityEvent<int> { }

        [SerializeField] int m_Value;

        public List<OptionData> options { get; set; } = new List<OptionData>();
        public DropdownEvent onValueChanged { get; set; } = new DropdownEvent();
        public Text captionText { get; set; }
        public int value
        {
            get => m_Value;
            set
            {
                value = Mathf.Clamp(value, 0, Mathf.Max(0, options.Count - 1));
                if (m_Value == value) return;
                m_Value = value;
                onValueChanged.Invoke(value);
            }
        }
        public void SetValueWithoutNotify(int input) => m_Value = input;
        public void RefreshShownValue() { }
        public void AddOptions(List<OptionData> added) => options.AddRange(added);
        public void AddOptions(List<string> added) { foreach (string text in added) options.Add(new OptionData(text)); }
        public void ClearOptions() { options.Clear(); m_Value = 0; }
        public void Show() { }
        public void Hide() { }
    }

    public class CanvasScaler : UIBehaviour
    {
        public enum ScaleMode { ConstantPixelSize, ScaleWithScreenSize, ConstantPhysicalSize }
        public ScaleMode uiScaleMode { get; set; }
        public float scaleFactor { get; set; } = 1;
        public float referencePixelsPerUnit { get; set; } = 100;
        public Vector2 referenceResolution { get; set; } = new Vector2(800, 600);
        public float matchWidthOrHeight { get; set; }
    }

    public class GraphicRaycaster : BaseRaycaster { public bool ignoreReversedGraphics { get; set; } = true; }

    public class LayoutElement : UIBehaviour
    {
        public virtual bool ignoreLayout { get; set; }
        public virtual float minWidth { get; set; } = -1;
        public virtual float minHeight { get; set; } = -1;
        public virtual float preferredWidth { get; set; } = -1;
        public virtual float preferredHeight { get; set; } = -1;
        public virtual float flexibleWidth { get; set; } = -1;
        public virtual float flexibleHeight { get; set; } = -1;
    }

    public abstract class LayoutGroup : UIBehaviour
    {
        public RectOffset padding { get; set; }
        public TextAnchor childAlignment { get; set; }
    }
    public abstract class HorizontalOrVerticalLayoutGroup : LayoutGroup
    {
        public float spacing { get; set; }
        public bool childForceExpandWidth { get; set; } = true;
        public bool childForceExpandHeight { get; set; } = true;
        public bool childControlWidth { get; set; } = true;
        public bool childControlHeight { get; set; } = true;
    }
    public class HorizontalLayoutGroup : HorizontalOrVerticalLayoutGroup { }
    public class VerticalLayoutGroup : HorizontalOrVerticalLayoutGroup { }
    public class GridLayoutGroup : LayoutGroup
    {
        public Vector2 cellSize { get; set; } = new Vector2(100, 100);
        public Vector2 spacing { get; set; }
        public int constraintCount { get; set; } = 2;
    }
    public class ContentSizeFitter : UIBehaviour
    {
        public enum FitMode { Unconstrained, MinSize, PreferredSize }
        public FitMode horizontalFit { get; set; }
        public FitMode verticalFit { get; set; }
    }
    public class AspectRatioFitter : UIBehaviour { public float aspectRatio { get; set; } = 1; }
    public class Mask : UIBehaviour { public bool showMaskGraphic { get; set; } = true; }
    public class RectMask2D : UIBehaviour { }

    public abstract class BaseMeshEffect : UIBehaviour { }
    public class Shadow : BaseMeshEffect
    {
        public Color effectColor { get; set; } = new Color(0, 0, 0, 0.5f);
        public Vector2 effectDistance { get; set; } = new Vector2(1, -1);
        public bool useGraphicAlpha { get; set; } = true;
    }
    public class Outline : Shadow { }

    public static class LayoutRebuilder
    {
        public static void ForceRebuildLayoutImmediate(RectTransform layoutRoot) { }
        public static void MarkLayoutForRebuild(RectTransform rect) { }
    }
}
